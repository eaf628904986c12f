// The predicates of geom/ in integers and rational numbers of any size: no filter, no bound,
// nothing to prove. Slow twins with the same signatures, for tests and for readers.
#pragma once

#include "geom/point.h"
#include "geom/sign.h"

namespace cocoon::ref {

Sign orient2d(double ax, double ay, double bx, double by, double cx, double cy);
Sign orient3d(const Point& a, const Point& b, const Point& c, const Point& d);
Sign insphere(const Point& a, const Point& b, const Point& c, const Point& d, const Point& e);

// Perturbs for real: lifts the point of lexicographic rank i by a rational epsilon^(5 - i), where
// epsilon is divided by 2^200 until three times in a row the sign stays. Same precondition as
// cocoon::insphere_perturbed.
Sign insphere_perturbed(const Point& a, const Point& b, const Point& c, const Point& d,
                        const Point& e);

// Center of the sphere through the four points, each coordinate rounded once. Precondition: the
// points are not coplanar.
Point circumcenter(const Point& a, const Point& b, const Point& c, const Point& d);

}  // namespace cocoon::ref
