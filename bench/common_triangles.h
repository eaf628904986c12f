// Meshes compared by the places of their triangles' corners, whatever their numbering.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <vector>

#include "geom/triangle_mesh.h"

namespace cocoon::bench {

// Sorted; which side they face does not count.
inline std::vector<std::array<Point, 3>> places_of_triangles(const TriangleMesh& mesh) {
  std::vector<std::array<Point, 3>> triangles;
  for (const auto& [a, b, c] : mesh.triangles) {
    auto& corners = triangles.emplace_back();
    corners = {mesh.points[a], mesh.points[b], mesh.points[c]};
    std::sort(corners.begin(), corners.end());
  }
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

// How many triangles both have. Complexity: O(t log t).
inline std::size_t common_triangles(const TriangleMesh& a, const TriangleMesh& b) {
  std::vector<std::array<Point, 3>> common;
  const auto of_a = places_of_triangles(a);
  const auto of_b = places_of_triangles(b);
  std::set_intersection(of_a.begin(), of_a.end(), of_b.begin(), of_b.end(),
                        std::back_inserter(common));
  return common.size();
}

}  // namespace cocoon::bench
