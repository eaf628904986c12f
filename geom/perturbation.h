// Symbolic perturbation: what insphere says when it says zero.
#pragma once

#include "geom/point.h"
#include "geom/sign.h"

namespace cocoon {

// insphere(a, b, c, d, e) with ties broken as if every point were lifted off the paraboloid by an
// infinitesimal that grows with the lexicographic rank of its coordinates. Precondition:
// orient3d(a, b, c, d) > 0. Zero iff e is one of a, b, c, d. The choice depends on the coordinates
// alone, so the Delaunay triangulation of a point set is unique, and it has no flat cell.
// Source: Devillers & Teillaud, Perturbations and vertex removal in a 3D Delaunay triangulation
// (SODA 2003), with the lexicographic order. Complexity: insphere, and on a tie at most two
// orient3d.
Sign insphere_perturbed(const Point& a, const Point& b, const Point& c, const Point& d,
                        const Point& e);

// The same for callers that know that insphere(a, b, c, d, e) is zero and that e is none of the
// others.
Sign break_cospherical_tie(const Point& a, const Point& b, const Point& c, const Point& d,
                           const Point& e);

}  // namespace cocoon
