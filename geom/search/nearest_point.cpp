#include "geom/search/nearest_point.h"

#include <limits>
#include <string>

#include "geom/errors.h"

namespace cocoon {

NearestPointTree::NearestPointTree(Points points, const Execution& execution) {
  if (points.empty()) throw InputError("there are no points, so that none is nearest; give some");
  std::vector<Box> boxes;
  boxes.reserve(points.size());
  for (const Point& p : points) {
    if (!is_finite(p)) {
      throw InputError("point " + std::to_string(boxes.size()) +
                       " has a coordinate that is not finite; remove it");
    }
    boxes.push_back({p, p});
  }
  tree_ = BoxTree(boxes, execution);
  points_.reserve(points.size());
  for (const std::uint32_t item : tree_.items()) points_.push_back(points[item]);
}

NearestPoint NearestPointTree::nearest(const Point& p) const {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  NearestPoint best;
  best.squared_distance = infinity;
  Point best_point;
  tree_.visit_near(p, infinity, [&](std::uint32_t slot) {
    const Point& candidate = points_[slot];
    const PointId id(tree_.items()[slot]);
    const double squared = squared_distance(p, candidate);
    const bool wins =
        squared < best.squared_distance || best.point.is_none() ||
        (squared == best.squared_distance &&
         (candidate != best_point ? (candidate <=> best_point) < 0 : id < best.point));
    if (wins) {
      best = {id, squared};
      best_point = candidate;
    }
    return best.squared_distance;
  });
  return best;
}

std::vector<NearestPointTree> nearest_point_trees(std::span<const std::vector<Point>> clouds,
                                                  const Execution& execution) {
  std::vector<NearestPointTree> trees;
  trees.reserve(clouds.size());
  for (const std::vector<Point>& cloud : clouds) trees.emplace_back(cloud, execution);
  return trees;
}

}  // namespace cocoon
