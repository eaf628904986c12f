// A point against a triangle: its projection to the plane (Woo & Dey 2005, Eq. 1-3) and the truly
// closest point.
#pragma once

#include <array>
#include <cstddef>

#include "geom/point.h"

namespace cocoon {

using TrianglePoints = std::array<Point, 3>;  // v0, v1, v2 of the equations

// Eq. 1  n = (v1 - v0) x (v2 - v0) / |.|
// Eq. 2  D = (p - v1) . n                       signed distance: positive on the side of n
// Eq. 3  p_proj = p - D n
struct PlaneProjection {
  double signed_distance = 0;              // D
  Point projected;                         // p_proj
  Vec3 normal;                             // n; the zero vector for a degenerate triangle
  std::array<double, 3> barycentric = {};  // of p_proj for v0, v1, v2; they sum to 1 up to rounding
  bool degenerate = false;                 // no plane to rely on: the other fields are 0

  // p_proj lies in the closed triangle. The paper asks whether the angles that the edges subtend at
  // p_proj sum to 2 pi, which is the same and needs three acos.
  bool is_inside() const {
    return !degenerate && barycentric[0] >= 0 && barycentric[1] >= 0 && barycentric[2] >= 0;
  }
};

// Degenerate are triangles whose largest angle has a sine below 2^-26: rounding alone decides about
// their normal. Floating point: D to a few roundings of the distance from a corner, of which narrow
// triangles make up to 2^26 times as much; a barycentric coordinate within rounding of 0 may come
// out on either side. Squared areas must be in the range of double: lengths within 2^-250 to 2^250.
// Complexity: O(1).
PlaneProjection project_to_triangle_plane(const Point& p, const TrianglePoints& triangle);

// Where on a triangle the closest point lies.
enum class TriangleFeature { vertex0, vertex1, vertex2, edge01, edge12, edge20, interior };

// A feature of {t[order[0]], t[order[1]], t[order[2]]} as one of the triangle t. O(1).
TriangleFeature renumbered(TriangleFeature feature, const std::array<std::size_t, 3>& order);

struct ClosestPoint {
  Point point;
  TriangleFeature feature = TriangleFeature::interior;
  double squared_distance = 0;
};

// The point of the closed triangle closest to p; of degenerate triangles that of their edges, or
// their single point, which is at most 2^-28 of the longest edge from it. Lengths as above.
// Complexity: O(1).
// Source: the Voronoi regions of a triangle, Ericson 2005, section 5.1.5.
ClosestPoint closest_point_on_triangle(const Point& p, const TrianglePoints& triangle);

}  // namespace cocoon
