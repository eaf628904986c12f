// On which side of a plane, or of a line, does a point lie? Exact for all finite doubles whose
// products neither overflow nor underflow (see docs/stages/predicates.md for the range).
#pragma once

#include "geom/point.h"
#include "geom/sign.h"

namespace cocoon {

// Sign of det[b - a; c - a; d - a]: positive iff d lies on the side of the plane abc to which the
// normal (b - a) x (c - a) points, zero iff the four points are coplanar.
// Complexity: O(1), a filter first, exact expansions only when it fails.
Sign orient3d(const Point& a, const Point& b, const Point& c, const Point& d);

// Sign of (b - a) x (c - a) in the plane, given by the two coordinates (x, y) of each point.
Sign orient2d(double ax, double ay, double bx, double by, double cx, double cy);

// True iff the three points of space lie on one line (exact: all three projections are).
bool are_collinear(const Point& a, const Point& b, const Point& c);

}  // namespace cocoon
