#include "geom/triangles_by_area.h"

#include <algorithm>
#include <cstddef>

#include "geom/random_point.h"

namespace cocoon {

TrianglesByArea::TrianglesByArea(const TriangleMesh& mesh) {
  double sum = 0;
  up_to_.reserve(mesh.triangles.size());
  for (const auto& [a, b, c] : mesh.triangles) {
    const Point& origin = mesh.points[a];
    sum += norm(cross(mesh.points[b] - origin, mesh.points[c] - origin)) / 2;
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
