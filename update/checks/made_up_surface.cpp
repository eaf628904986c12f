#include "update/checks/made_up_surface.h"

#include <cmath>
#include <vector>

#include "geom/search/closest_facet.h"
#include "update/stage_options.h"

namespace cocoon {

MadeUpSurface made_up_surface(const TriangleMesh& model, const TriangleMesh& updated,
                              std::span<const TriangleId> added, const UnscannedPlaces& unscanned,
                              const MadeUpOptions& options) {
  require_options("made_up_surface", options);
  MadeUpSurface made_up;
  const std::vector<ModelPlace> places = unscanned.of(updated, added);
  if (places.empty()) return made_up;
  const ClosestFacetTree tree(model);
  const double limit = options.distance * unscanned.spacing();
  for (const auto& [at, area] : places) {
    const double distance = std::sqrt(tree.closest(at).squared_distance);
    if (!(distance > limit)) continue;
    ++made_up.places;
    made_up.area += area;
    if (distance <= made_up.distance) continue;
    made_up.distance = distance;
    made_up.farthest = at;
  }
  return made_up;
}

}  // namespace cocoon
