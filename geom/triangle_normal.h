// The direction of a triangle's normal, right even for triangles that are almost a line.
#pragma once

#include "geom/point.h"

namespace cocoon {

struct TriangleNormal {
  Vec3 direction;      // unit length; zero iff the vertices lie on one line (exact)
  bool exact = false;  // floating point did not suffice, integers were used
};

// (b - a) x (c - a): the normal in floating point, as long as twice the area. O(1).
constexpr Vec3 area_normal(const Point& a, const Point& b, const Point& c) {
  return cross(b - a, c - a);
}

// The direction of (b - a) x (c - a): the side from which a, b, c run counterclockwise. Off by less
// than 1e-6 radians in floating point (about 1e-16 for well-shaped triangles), and by a few
// roundings from integers. Computed from the vertices in lexicographic order: any order of the same
// vertices gives the same bits, up to the sign that orientation demands.
// Precondition: finite coordinates, of any magnitude. Complexity: O(1).
TriangleNormal triangle_normal(const Point& a, const Point& b, const Point& c);

}  // namespace cocoon
