#include "update/checks/dense_trial.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "geom/mesh/triangles_by_area.h"
#include "geom/search/closest_facet.h"
#include "geom/search/neighbor_distance.h"
#include "update/checks/model_places.h"
#include "update/stage_options.h"

namespace cocoon {

namespace {

std::vector<Scan> scans_before(std::span<const std::vector<Point>> clouds,
                               const DenseTrialOptions& options) {
  std::vector<Scan> scans;
  for (const std::vector<Point>& cloud : clouds) {
    scans.push_back(
        {cloud, options.neighbor_share * median_neighbor_distance(cloud, options.neighbor)});
  }
  return scans;
}

// Of each place whether its surface goes with the change of the dense model.
std::vector<std::uint8_t> are_replaced(const std::vector<ModelPlace>& places, double reach,
                                       const TrialUpdate& dense) {
  const ClosestFacetTree tree(dense.model);
  const auto& point_of_vertex = dense.result.replacement.point_of_vertex;
  std::vector<std::uint8_t> replaced;
  std::uint32_t slot = 0;
  for (const ModelPlace& place : places) {
    const ClosestFacet facet = tree.closest(place.at, slot);
    const Triangle& corners = dense.model.triangles[facet.triangle];
    const bool goes = std::any_of(corners.begin(), corners.end(),
                                  [&](VertexId v) { return point_of_vertex[v].is_none(); });
    replaced.push_back(goes && facet.squared_distance <= reach * reach ? 1 : 0);
  }
  return replaced;
}

}  // namespace

double dense_spacing(const TriangleMesh& model, std::span<const std::vector<Point>> clouds,
                     const DenseTrialOptions& options) {
  require_options("dense_spacing", options);
  const double area = TrianglesByArea(model).area();
  return std::max(largest_spacing(scans_before(clouds, options)),
                  std::sqrt(area / options.most_samples));
}

bool has_large_triangles(const TriangleMesh& model, std::span<const std::vector<Point>> clouds,
                         double share, const DenseTrialOptions& options) {
  require_options("has_large_triangles", options);
  const double limit = large_side(scans_before(clouds, options), options.lost.astray);
  double area = 0;
  double large = 0;
  for (const TriangleId t : model.triangles.ids()) {
    const double own = area_of(model, t);
    area += own;
    if (longest_edge(model, t) > limit) large += own;
  }
  return large > 0 && large >= share * area;
}

bool is_worth_dense_trial(const TriangleMesh& model, std::span<const std::vector<Point>> clouds,
                          const UpdateResult& result, const LostSurface& lost,
                          const DenseTrialOptions& options) {
  require_options("is_worth_dense_trial", options);
  if (result.status == UpdateStatus::ok) {
    return (lost.warns && lost.is_coarse) || lost.large_share > options.lost.min_coarse_share;
  }
  return has_large_triangles(model, clouds, options.min_large_share_if_refused, options);
}

KeptAreas kept_areas(const TrialUpdate& first, const TrialUpdate& dense,
                     std::span<const Scan> scans, const AstrayOptions& options) {
  const bool first_is_ok = first.result.status == UpdateStatus::ok;
  const UnscannedPlaces unscanned(scans, options);
  const std::vector<ModelPlace> places = unscanned.of(first.model);
  const std::vector<std::uint8_t> off_dense = unscanned.are_off(places, dense.result.mesh);
  const std::vector<std::uint8_t> off_first = first_is_ok
                                                  ? unscanned.are_off(places, first.result.mesh)
                                                  : std::vector<std::uint8_t>(places.size(), 1);
  const std::vector<std::uint8_t> replaced = are_replaced(places, unscanned.reach(), dense);
  KeptAreas areas;
  areas.made_up_by_dense = unscanned.area_off(unscanned.of(dense.result.mesh), first.model);
  if (first_is_ok) {
    areas.made_up_by_first = unscanned.area_off(unscanned.of(first.result.mesh), first.model);
  }
  for (std::size_t k = 0; k < places.size(); ++k) {
    const double area = places[k].area;
    areas.all += area;
    if (off_dense[k] == 0) {
      areas.only_dense += off_first[k] != 0 ? area : 0;
    } else if (replaced[k] == 0) {
      (off_first[k] != 0 ? areas.neither : areas.only_first) += area;
    }
  }
  return areas;
}

bool keeps_more(const KeptAreas& areas, bool first_is_ok, const DenseTrialOptions& options) {
  require_options("keeps_more", options);
  if (!first_is_ok) {
    return areas.neither + areas.made_up_by_dense <= options.lost.min_area_share * areas.all;
  }
  const double better = areas.only_dense + areas.made_up_by_first;
  const double worse = areas.only_first + areas.made_up_by_dense;
  return areas.all > 0 && better > options.lost.min_coarse_share * areas.all &&
         worse <= options.max_given_up * better;
}

}  // namespace cocoon
