#include "update/cloud/rim_index.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geom/closest_on_segment.h"

namespace cocoon {

namespace {

// Edges within this share of the least distance count as equally near: those that end at one point.
constexpr double equal_distance = 1e-9;

}  // namespace

RimIndex::RimIndex(std::span<const CloudRim> rims) {
  std::vector<Box> boxes;
  for (std::size_t r = 0; r < rims.size(); ++r) {
    for (const RimLoop& loop : rims[r].loops) {
      const bool is_partial = loop.is_partial();
      for (std::size_t i = 0; i < loop.size(); ++i) {
        if (loop.is_inner(i)) continue;
        const Point& from = loop.points[i];
        const Point& to = loop.points[loop.next(i)];
        const Vec3 along = unit(to - from);
        const Vec3 apex = loop.apexes[i] - from;
        edges_.push_back({from, to, unit(apex - dot(apex, along) * along),
                          static_cast<std::uint32_t>(r), is_partial});
        Box box;
        box.include(from);
        box.include(to);
        boxes.push_back(box);
      }
    }
  }
  tree_ = BoxTree(boxes);
}

RimSide RimIndex::side_of(const Point& p) const {
  // 1. The least distance.
  double least = std::numeric_limits<double>::infinity();
  auto squared_to = [&](const Edge& edge) {
    return squared_distance(p, closest_on_segment(p, edge.from, edge.to));
  };
  tree_.visit_near(p, least, [&](std::uint32_t slot) {
    least = std::min(least, squared_to(edges_[tree_.items()[slot]]));
    return least;
  });

  // 2. All edges at that distance, in rim order.
  const double reach = least * (1 + equal_distance);
  std::vector<std::uint32_t> nearest;
  tree_.visit_near(p, reach, [&](std::uint32_t slot) {
    const std::uint32_t item = tree_.items()[slot];
    if (squared_to(edges_[item]) <= reach) nearest.push_back(item);
    return reach;
  });
  std::sort(nearest.begin(), nearest.end());

  // 3. The side: cosine of the wedge angle, times a positive factor.
  double side = 0;
  for (const std::uint32_t item : nearest) {
    const Edge& edge = edges_[item];
    side += dot(p - closest_on_segment(p, edge.from, edge.to), edge.inward);
  }
  if (nearest.empty()) return {.distance = std::sqrt(least)};
  const Edge& first = edges_[nearest.front()];
  return {std::sqrt(least), first.rim, side > 0, first.of_partial_loop};
}

}  // namespace cocoon
