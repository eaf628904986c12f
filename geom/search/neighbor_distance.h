// How far apart the points of a set lie.
#pragma once

#include <cstddef>

#include "geom/point.h"

namespace cocoon {

// The distance of a point from its k-th nearest neighbor, the median over some hundred of the
// points; equal points count once. 0 if there are no k others. Precondition: finite points. Errors:
// InputError if k is 0. Coordinates may have any size, but distances below 2^-500 of it may come
// out as 0. Complexity: O(n log n) for n points. A function of the set of points.
double median_neighbor_distance(Points points, std::size_t k);

}  // namespace cocoon
