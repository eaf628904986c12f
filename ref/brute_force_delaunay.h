// The Delaunay triangulation straight from its definition, to read first and to test against.
#pragma once

#include <cstddef>

#include "delaunay/triangulation.h"
#include "geom/point.h"

namespace cocoon::ref {

// A tetrahedron of the points belongs to the triangulation iff no other point lies inside its
// circumsphere (ties by insphere_perturbed). This asks it of all tetrahedra and all points.
// Same result as delaunay(points) as a set of cells; layout as cgal_delaunay.
// Errors: InputError as delaunay() (not finite, fewer than four different points, coplanar).
// Complexity: O(n^5); meant for n <= 30.
// Source: Delaunay 1934.
Triangulation brute_force_delaunay(Points points);

// Pairs of a finite cell and a vertex inside its circumsphere (ties by insphere_perturbed): a
// triangulation is Delaunay iff there are none. Precondition: cells are positively oriented.
// Complexity: O(cells * vertices).
std::size_t occupied_pairs(const Triangulation& triangulation);

}  // namespace cocoon::ref
