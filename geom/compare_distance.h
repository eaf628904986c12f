// Which of two points is nearer? Exact for all finite doubles.
#pragma once

#include "geom/point.h"
#include "geom/sign.h"

namespace cocoon {

// Sign of |a - p|^2 - |b - p|^2: negative iff a is nearer to p than b, zero iff both are equally
// far. Precondition: finite coordinates. Complexity: O(1); a floating-point filter decides nearly
// all calls, the others exact integers.
Sign compare_distance(const Point& p, const Point& a, const Point& b);

}  // namespace cocoon
