#include "geom/mesh/triangles_by_area.h"

#include <algorithm>
#include <cstddef>

#include "geom/random/random_point.h"
#include "geom/triangle_normal.h"

namespace cocoon {

// Beside a corner far out, the square of an area may be too small for a double, the area not.
double area_of(const TriangleMesh& mesh, TriangleId triangle) {
  constexpr double smallest_square = 0x1p-960;  // relative to which subnormal numbers are nothing
  const auto [a, b, c] = corners_of(mesh, triangle);
  const Vec3 across = area_normal(a, b, c);
  if (squared_norm(across) >= smallest_square) return norm(across) / 2;
  const double largest = max_norm(across);
  return largest > 0 ? largest * norm(across / largest) / 2 : 0;
}

TrianglesByArea::TrianglesByArea(const TriangleMesh& mesh) {
  double sum = 0;
  up_to_.reserve(mesh.triangles.size());
  for (const TriangleId t : mesh.triangles.ids()) {
    sum += area_of(mesh, t);
    up_to_.push_back(sum);
  }
}

// The last one, should rounding have carried the place to the end.
TriangleId TrianglesByArea::at(double place) const {
  const auto found = std::upper_bound(up_to_.begin(), up_to_.end() - 1, place);
  return TriangleId(static_cast<std::size_t>(found - up_to_.begin()));
}

Point random_point_in(const TriangleMesh& mesh, TriangleId triangle, Random& random) {
  const auto [a, b, c] = corners_of(mesh, triangle);
  return random_point_in(a, b, c, random);
}

}  // namespace cocoon
