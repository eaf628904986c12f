// The definition of poles: every cell is asked whether it belongs to the sample.
#pragma once

#include "cocone/poles.h"
#include "delaunay/triangulation.h"
#include "delaunay/voronoi_dual.h"

namespace cocoon::ref {

// What compute_poles must give. Only the normal of a sample whose unbounded edges nearly cancel out
// is that of the product, hull_normal; `cgal_cocone` finds it in its own way. Complexity:
// O(vertices * cells).
Poles brute_force_poles(const Triangulation& triangulation, const Dual& dual);

}  // namespace cocoon::ref
