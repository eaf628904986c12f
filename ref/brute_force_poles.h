// The definition of poles, word for word: every cell is asked whether it belongs to the sample.
#pragma once

#include "cocone/poles.h"
#include "delaunay/triangulation.h"
#include "delaunay/voronoi_dual.h"

namespace cocoon::ref {

// What compute_poles must give. Complexity: O(vertices * cells).
Poles brute_force_poles(const Triangulation& triangulation, const Dual& dual);

}  // namespace cocoon::ref
