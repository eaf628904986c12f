#include "update/regions/sampled_regions.h"

#include <algorithm>
#include <string>
#include <vector>

#include "geom/errors.h"
#include "geom/mesh/triangles_by_area.h"
#include "geom/search/nearest_point.h"
#include "geom/triangle_normal.h"
#include "update/model/near_facets.h"
#include "update/model/triangle_set.h"
#include "update/stage_options.h"

namespace cocoon {

namespace {

struct CoveredArea {
  double covered = 0;
  double all = 0;
  double share() const { return all > 0 ? covered / all : 0; }
};

}  // namespace

IdVector<RegionId, std::uint8_t> regions_under_samples(
    const ModelIndex& model, const Regions& regions, std::span<const RegionId> asked,
    const Scan& scan, const SampledRegionOptions& options, const Execution& execution) {
  require_options("regions_under_samples", options);
  const std::size_t num_regions = regions.regions.size();
  IdVector<RegionId, std::uint8_t> is_asked(num_regions, 0);
  for (const RegionId r : asked) {
    if (r.index() >= num_regions) {
      throw InputError("regions_under_samples: there is no region " + std::to_string(r.value));
    }
    is_asked[r] = 1;
  }
  if (scan.samples.empty()) return {};
  std::vector<Point> places;
  for (const Point& p : scan.samples) places.push_back(p - scan.shift);
  const double reach = options.reach * scan.spacing;
  const TriangleMesh& mesh = model.mesh();
  TriangleSet has_foot(mesh.triangles.size(), 0);
  std::vector<Point> feet;
  for (const ClosestFacet& closest : closest_facets(model, places, 2 * reach, execution)) {
    has_foot[closest.triangle] = 1;
    feet.push_back(closest.point);
  }
  const NearestPointTree tree(feet, execution);
  IdVector<RegionId, CoveredArea> areas(num_regions);
  for (const TriangleId t : mesh.triangles.ids()) {
    const RegionId r = regions.region_of_facet[t];
    if (r.is_none() || is_asked[r] == 0) continue;
    const double area = area_of(mesh, t);
    areas[r].all += area;
    if (has_foot[t] != 0 || tree.any_near(model.centroid(t), reach)) areas[r].covered += area;
  }
  IdVector<RegionId, std::uint8_t> under(num_regions, 0);
  std::size_t outside = 0;
  for (const RegionId r : asked) {
    const double share = areas[r].share();
    under[r] = share >= options.min_share ? 1 : 0;
    if (under[r] == 0 && share > options.max_outside_share) return {};
    outside += under[r] == 0 ? 1U : 0U;
  }
  if (outside == 0 || std::count(under.begin(), under.end(), 1) == 0) return {};
  return under;
}

}  // namespace cocoon
