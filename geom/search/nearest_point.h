// The point of a set closest to a given point.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "geom/box.h"
#include "geom/execution.h"
#include "geom/ids.h"
#include "geom/point.h"
#include "geom/search/box_tree.h"

namespace cocoon {

struct NearestPoint {
  PointId point;  // position in the points that the tree was made of
  double squared_distance = 0;

  friend bool operator==(const NearestPoint&, const NearestPoint&) = default;
};

// Search tree over points, of which it keeps a copy.
class NearestPointTree {
 public:
  // Throws InputError for no points or a coordinate that is not finite. Complexity: O(n log n),
  // parallel.
  explicit NearestPointTree(Points points, const Execution& execution = {});

  // The point nearest to p; at equal computed distance the lexicographically smallest one, of equal
  // points the one given first. p must be finite, squared distances in the range of double.
  // Complexity: O(log n) on ordinary sets, O(n) at worst. Thread-safe.
  NearestPoint nearest(const Point& p) const;

  // Whether holds(id) for some point at most `reach` from p, which is faster than to look for the
  // nearest one. Asks in no order. Complexity: O(log n) on ordinary sets if one of the first that
  // are near does, and one call for each that is near. Thread-safe.
  template <class Holds>
  bool any_near(const Point& p, double reach, const Holds& holds) const {
    bool found = false;
    const double bound = reach * reach;
    tree_.visit_near(p, bound, [&](std::uint32_t slot) {
      found = found ||
              (squared_distance(p, points_[slot]) <= bound && holds(PointId(tree_.items()[slot])));
      return found ? -1.0 : bound;
    });
    return found;
  }
  bool any_near(const Point& p, double reach) const {
    return any_near(p, reach, [](PointId) { return true; });
  }

  // Of all points.
  Box box() const { return tree_.box(); }
  std::size_t size() const { return points_.size(); }

 private:
  BoxTree tree_;
  std::vector<Point> points_;  // by slot of the tree
};

// One tree for each cloud, none of which is empty. Errors, complexity: as NearestPointTree.
std::vector<NearestPointTree> nearest_point_trees(std::span<const std::vector<Point>> clouds,
                                                  const Execution& execution = {});

}  // namespace cocoon
