#include "geom/triangles_by_area.h"

#include <algorithm>
#include <cstddef>

#include "geom/random_point.h"

namespace cocoon {

double area_of(const TriangleMesh& mesh, TriangleId triangle) {
  const auto [a, b, c] = corners_of(mesh, triangle);
  return norm(cross(b - a, c - a)) / 2;
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
