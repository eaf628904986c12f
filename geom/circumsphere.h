// Centers of the spheres through the vertices of a tetrahedron or a triangle: constructions in
// floating point, which say how they were obtained. Decisions about spheres are geom/insphere.h.
#pragma once

#include "geom/point.h"

namespace cocoon {

enum class CenterLevel {
  doubles,   // floating point; the error is certified, see below
  exact,     // it is not: integer numerators and denominator, each rounded once, and divided
  facet,     // tetrahedron flat, or center beyond the largest double: center of a facet
  centroid,  // no facet either, or a triangle with its vertices on a line: mean of the vertices
};

struct Circumcenter {
  Point center;  // always finite
  CenterLevel level = CenterLevel::doubles;
};

// Center of the sphere through a, b, c, d, computed relative to the lexicographically smallest
// vertex with the others in lexicographic order: any order of the same vertices gives the same
// bits.
//
//   center - a = (|u|^2 v x w + |v|^2 w x u + |w|^2 u x v) / (2 u . v x w),  u, v, w = b, c, d - a.
//
// Level `doubles`: the rounding errors are bounded, and center - a is within 2^-23 radius on every
// axis; so the distances to the vertices agree to 1e-6. Comparing distances alone would not do:
// they hardly notice when the center of a sliver slips along its axis. Level `exact`: center - a
// within 4 roundings per coordinate. Both: one rounding more for a + (center - a), which at far
// offsets is all that can be had.
// Precondition: finite coordinates, of any magnitude. `facet`: the first facet in lexicographic
// order whose center is finite. Complexity: O(1).
// Source: the fallbacks of Cocone implementations, in stricter form (docs/stages/predicates.md).
Circumcenter circumcenter(const Point& a, const Point& b, const Point& c, const Point& d);

// Center of the smallest sphere through a, b, c; the same rules and levels (never `facet`).
//
//   center - a = (|v|^2 n x u - |u|^2 n x v) / (2 |n|^2),  u, v = b, c - a,  n = u x v.
Circumcenter circumcenter(const Point& a, const Point& b, const Point& c);

}  // namespace cocoon
