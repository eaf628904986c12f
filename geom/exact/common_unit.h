// Coordinates on a grid: scanners and CAD systems often deliver multiples of one small step.
#pragma once

#include "geom/execution.h"
#include "geom/point.h"

namespace cocoon {

// The largest power of two of which every coordinate is an integer multiple; 0 if all coordinates
// are zero or there is no point. Arithmetic on differences of such coordinates is exact as long as
// the results stay below 2^53 units (to the power of the degree).
// Precondition: finite coordinates. Complexity: O(n).
double common_unit(Points points, const Execution& execution = {});
double common_unit(const Point& point);

}  // namespace cocoon
