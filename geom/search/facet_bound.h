// A lower bound for the distance of points from a triangle, for a fifth of the operations.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "geom/point.h"
#include "geom/triangle_projection.h"

namespace cocoon {

// A triangle lies in its plane, on the inner side of each of the three planes through its edges
// that are upright on it. How far a point is off the one and beyond the others bounds its distance;
// unless the closest point is a vertex that is the distance. Narrow triangles bound less by what
// rounding makes of their normals, those without area nothing.
class FacetBound {
 public:
  // Bounds nothing.
  FacetBound() = default;
  // Precondition: finite corners, lengths within those of triangle_projection.h. O(1).
  explicit FacetBound(const TrianglePoints& corners);

  // At most the square of the distance from p that closest_point_on_triangle() computes.
  // `largest`: the largest of p's coordinates, max_norm(p). Precondition and complexity: the same.
  double squared_distance(const Point& p, double largest) const {
    std::array<double, 4> beyond;
    for (std::size_t k = 0; k < 4; ++k) {
      beyond[k] = (x_[k] * p.x + y_[k] * p.y + z_[k] * p.z) - offset_[k];
    }
    const double rounding = rounding_ * (largest_ + largest);
    const double off_plane = std::max(std::abs(beyond[0]) - rounding, 0.0);
    const double off_edges = std::max(std::max(beyond[1], beyond[2]), beyond[3]) - rounding;
    return less_rounding * (off_plane * off_plane + std::max(off_edges, 0.0) * off_edges);
  }

 private:
  // Of squares: more than the normals are off from unit length and right angles.
  static constexpr double less_rounding = 1 - 0x1p-40;

  std::array<double, 4> x_{}, y_{}, z_{};  // normals of the plane, and of the edges outward
  std::array<double, 4> offset_{};         // of the triangle along these
  double largest_ = 0;                     // of the corners' coordinates
  double rounding_ = 0;                    // of distances, per largest coordinate
};

}  // namespace cocoon
