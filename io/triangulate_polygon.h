// Cuts one polygon of a mesh file into triangles.
#pragma once

#include <span>
#include <vector>

#include "geom/point.h"
#include "geom/triangle_mesh.h"

namespace cocoon {

// Replaces `triangles` by corners.size() - 2 triangles with the polygon's orientation, whose
// boundary is the polygon. Precondition: at least three corners, all of them ids of `points`.
//
// A polygon whose corners all turn the same way, seen along its area vector, is cut as a fan from
// its first corner: the usual choice, and what most other readers do. Any other polygon loses ears:
// always the first convex corner, in the polygon's order, whose triangle holds no other corner. If
// none is left (a polygon that crosses itself, or collapses to a line), the rest is cut as a fan.
// The projection is computed in floating point: rounding can change which triangles are chosen,
// never their number or their boundary. Complexity: O(n) for a fan, else O(n^3) at worst, O(n^2)
// usually.
void triangulate_polygon(Points points, std::span<const VertexId> corners,
                         std::vector<Triangle>& triangles);

}  // namespace cocoon
