// The point of a set closest to a given point.
#pragma once

#include <vector>

#include "geom/box_tree.h"
#include "geom/execution.h"
#include "geom/ids.h"
#include "geom/point.h"

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

 private:
  BoxTree tree_;
  std::vector<Point> points_;  // by slot of the tree
};

}  // namespace cocoon
