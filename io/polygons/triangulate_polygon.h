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
// always the first convex corner, in the polygon's order, whose triangle lies inside the polygon.
// The polygon may touch itself, as one with a hole does that is joined to its outline by a bridge
// there and back. Corners at the place of the next one are cut off first: triangles without area,
// as are those of corners where the polygon runs straight on or back, the last to be cut. If none
// of these is left (a polygon that crosses itself), the rest is cut as a fan.
//
// All decisions are exact for the polygon projected along the axis closest to its area vector,
// which is computed in floating point: of polygons that lie in no plane the triangles may depend on
// that axis, never their number or their boundary. Complexity: O(n) for a fan, else O(n log n)
// usually. Corners at places where the polygon touches itself are looked at again after each cut
// among them, in O(n): with k of them it may be O(k^2 n), as for holes by the thousand.
// Source: Meisters 1975, "Polygons have ears"; holes by bridges: Held 2001, "FIST".
void triangulate_polygon(Points points, std::span<const VertexId> corners,
                         std::vector<Triangle>& triangles);

}  // namespace cocoon
