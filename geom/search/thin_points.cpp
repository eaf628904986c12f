#include "geom/search/thin_points.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <numeric>

#include "geom/search/box_tree.h"
#include "geom/working_scale.h"

namespace cocoon {

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
  // Where the square is too small for a double, only equal points are that close.
  const double reach =
      std::max(distance * scale * (distance * scale), std::numeric_limits<double>::denorm_min());
  const auto reach_at = [&](PointId) { return reach; };
  return scale == 1 ? thin_points(points, reach_at) : thin_points(scaled(points, scale), reach_at);
}

}  // namespace cocoon
