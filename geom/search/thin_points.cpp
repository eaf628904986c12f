#include "geom/search/thin_points.h"

#include <algorithm>
#include <cstdint>
#include <numeric>

#include "geom/search/box_tree.h"
#include "geom/search/equal_points.h"
#include "geom/working_scale.h"

namespace cocoon {
namespace {

// Below this fraction of the size of coordinates squares of distances may be no doubles.
constexpr double smallest_distance = 0x1p-500;

std::vector<PointId> first_of_equal(Points points) {
  const std::vector<RepeatedPoint> repeated = repeated_points(points);
  auto next = repeated.begin();
  std::vector<PointId> kept;
  for (std::uint32_t k = 0; k < points.size(); ++k) {
    if (next != repeated.end() && next->point == k) {
      ++next;
    } else {
      kept.emplace_back(k);
    }
  }
  return kept;
}

}  // namespace

std::vector<PointId> thin_points(Points points,
                                 const std::function<double(PointId)>& squared_distance_at) {
  const BoxTree tree = tree_of_points(points);
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return points[a] < points[b]; });
  std::vector<std::uint8_t> left_out(points.size(), 0);
  std::vector<PointId> kept;
  for (const std::uint32_t k : order) {
    if (left_out[k] != 0) continue;
    kept.emplace_back(k);
    const double reach = squared_distance_at(PointId(k));
    tree.visit_near(points[k], reach, [&](std::uint32_t slot) {
      const std::uint32_t other = tree.items()[slot];
      if (squared_distance(points[other], points[k]) < reach) left_out[other] = 1;
      return reach;
    });
  }
  std::sort(kept.begin(), kept.end());
  return kept;
}

std::vector<PointId> thin_points(Points points, double distance) {
  const double scale = working_scale(points);
  if (!(distance * scale >= smallest_distance)) return first_of_equal(points);
  const double reach = distance * scale * (distance * scale);
  const auto reach_at = [&](PointId) { return reach; };
  return scale == 1 ? thin_points(points, reach_at) : thin_points(scaled(points, scale), reach_at);
}

}  // namespace cocoon
