// Points left out so that those that are left keep their distance.
#pragma once

#include <functional>
#include <vector>

#include "geom/ids.h"
#include "geom/point.h"

namespace cocoon {

// Greedy thinning. Points have their turn in lexicographic order, of equal ones the first first; a
// point is kept unless it is closer to one that was kept, point k, than
// sqrt(squared_distance_at(k)). Returns the ids of those kept, increasing: a function of the set of
// points. Squares of distances must be in the range of double. Complexity: O(n log n) for n points,
// if few lie within that distance of each; equal points for which it is 0 are all kept, and each
// looks at all of them. Source: Poisson disk sampling by elimination in a fixed order.
std::vector<PointId> thin_points(Points points,
                                 const std::function<double(PointId)>& squared_distance_at);

// The same with one distance, 0 or more, for all, and for coordinates of any size; of equal points
// the first stays, also with 0. Distances below 2^-500, or below that fraction of the largest
// coordinate where this is no working size (working_scale.h), are taken for 0.
std::vector<PointId> thin_points(Points points, double distance);

}  // namespace cocoon
