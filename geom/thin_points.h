// Points left out so that those that are left keep their distance.
#pragma once

#include <functional>
#include <vector>

#include "geom/ids.h"
#include "geom/point.h"

namespace cocoon {

// Some of the points, increasing: each point left out is closer to one of these than
// sqrt(squared_distance_at(k)) for that one, point k, and of these none is so close to one before
// it. Points have their turn in lexicographic order, of equal ones the first: a function of the
// set of points. Complexity: O(n log n) for n points, with neighbors as many as lie within that
// distance; equal points for which it is 0 are all kept, and each looks at all of them. Source:
// Poisson disk sampling by elimination in a fixed order.
std::vector<PointId> thin_points(Points points,
                                 const std::function<double(PointId)>& squared_distance_at);

// The same with one distance, 0 or more, for all, and for coordinates of any size; of equal points
// the first stays, also with 0.
std::vector<PointId> thin_points(Points points, double distance);

}  // namespace cocoon
