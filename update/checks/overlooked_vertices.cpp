#include "update/checks/overlooked_vertices.h"

#include <algorithm>

#include "geom/messages/require_size.h"
#include "update/cloud/rim_index.h"
#include "update/cloud/scanned_places.h"
#include "update/model/require_ascending.h"
#include "update/stage_options.h"

namespace cocoon {

OverlookedVertices overlooked_vertices(const ModelIndex& model, std::span<const VertexId> removed,
                                       std::span<const CloudRim> rims,
                                       std::span<const NearestPointTree> clouds,
                                       const OverlookedOptions& options) {
  require_options("overlooked_vertices", options);
  require_size("overlooked_vertices", "trees of samples", clouds.size(), rims.size());
  require_ascending("overlooked_vertices", "removed vertices", removed, model.mesh().points.size());
  const RimIndex rim_index(rims);
  if (rim_index.empty()) return {};
  ScannedPlaces scanned;
  for (std::size_t c = 0; c < clouds.size(); ++c) {
    scanned.add(clouds[c], options.reach * rims[c].median_edge);
  }
  OverlookedVertices found;
  double farthest = -1;
  model.for_each_vertex_in(scanned.box(), [&](VertexId v) {
    const Point& p = model.mesh().points[v];
    if (!model.is_used(v) || !scanned.contain(p)) return;
    ++found.scanned;
    if (std::binary_search(removed.begin(), removed.end(), v)) return;
    ++found.kept;
    const RimSide side = rim_index.side_of(p);
    const double edges = side.distance / rims[side.rim].median_edge;
    if (edges > options.min_rim_distance) found.vertices.push_back(v);
    if (!(edges > farthest)) return;
    farthest = edges;
    found.farthest = v;
  });
  return found;
}

}  // namespace cocoon
