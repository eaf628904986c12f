// Does a point lie inside the sphere through four others? Exact for all finite doubles in the
// range stated in docs/stages/predicates.md.
#pragma once

#include "geom/point.h"
#include "geom/sign.h"

namespace cocoon {

// For orient3d(a, b, c, d) > 0: positive iff e lies inside the sphere through a, b, c, d, zero iff
// on it, negative iff outside. Complexity: O(1), filter, then exact expansions.
Sign insphere(const Point& a, const Point& b, const Point& c, const Point& d, const Point& e);

}  // namespace cocoon
