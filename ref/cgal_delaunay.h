// The oracle of the Delaunay kernel: CGAL's triangulation in the project's layout.
#pragma once

#include "delaunay/triangulation.h"
#include "geom/point.h"

namespace cocoon::ref {

// What delaunay(points) must equal as a set of cells: CGAL's Delaunay_triangulation_3 over
// Exact_predicates_inexact_constructions_kernel breaks cospherical ties by the same lexicographic
// perturbation. Ids differ from the kernel's: vertices in lexicographic order of their points,
// cells ascending by their vertices. Points may come in any order and repeat.
// Errors: InputError as delaunay() (not finite, fewer than four different points, coplanar).
// Range: CGAL's predicates assume that products of five differences neither overflow nor underflow.
// Complexity: O(n log n) expected for points in volumes and on surfaces, one thread.
// Source: Jamin, Pion & Teillaud, 3D Triangulations, CGAL User and Reference Manual.
Triangulation cgal_delaunay(Points points);

}  // namespace cocoon::ref
