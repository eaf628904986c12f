// A triangle mesh as plain data. Adjacency, checks and measures are computed from it by the other
// files of this folder; nothing is cached in it.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "geom/execution.h"
#include "geom/id_vector.h"
#include "geom/point.h"

namespace cocoon {

// Triangles are counterclockwise as seen from outside.
struct TriangleMesh {
  IdVector<VertexId, Point> points;
  IdVector<TriangleId, Triangle> triangles;

  friend bool operator==(const TriangleMesh&, const TriangleMesh&) = default;
};

// Whether two corners are the same vertex.
constexpr bool repeats_a_vertex(const Triangle& t) {
  return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
}

// Where the smallest vertex is; of equal ones the first. Which corner it is cannot be foreseen: by
// sums, where compilers would make branches.
constexpr std::size_t smallest_corner(const Triangle& t) {
  const std::size_t second = t[1] < t[0] ? 1U : 0U;
  const std::size_t third = t[2] < std::min(t[0], t[1]) ? 1U : 0U;
  return 2 * third + (second & (third ^ 1U));
}

// The points of a triangle, in the order of its vertices. Precondition: they are there. O(1).
inline std::array<Point, 3> corners_of(const TriangleMesh& mesh, TriangleId triangle) {
  const auto& [a, b, c] = mesh.triangles[triangle];
  return {mesh.points[a], mesh.points[b], mesh.points[c]};
}

// The corners of a triangle in lexicographic order; and in its own, from the smallest on. What is
// computed from them does not depend on which corner comes first. Complexity: O(1).
inline std::array<Point, 3> sorted_corners(std::array<Point, 3> corners) {
  std::sort(corners.begin(), corners.end());
  return corners;
}
inline std::array<Point, 3> corners_from_smallest(std::array<Point, 3> corners) {
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  return corners;
}

// The length of edge i of a triangle, opposite its corner i, in units of the coordinates; and that
// of its shortest, its median and its longest edge. Precondition: as corners_of. O(1).
inline double edge_length(const TriangleMesh& mesh, TriangleId triangle, std::size_t i) {
  const Triangle& corners = mesh.triangles[triangle];
  return distance(mesh.points[corners[(i + 1) % 3]], mesh.points[corners[(i + 2) % 3]]);
}
inline double shortest_edge(const TriangleMesh& mesh, TriangleId triangle) {
  return std::min({edge_length(mesh, triangle, 0), edge_length(mesh, triangle, 1),
                   edge_length(mesh, triangle, 2)});
}
inline double median_edge(const TriangleMesh& mesh, TriangleId triangle) {
  const auto [low, high] =
      std::minmax({edge_length(mesh, triangle, 0), edge_length(mesh, triangle, 1)});
  return std::clamp(edge_length(mesh, triangle, 2), low, high);
}
inline double longest_edge(const TriangleMesh& mesh, TriangleId triangle) {
  return std::max({edge_length(mesh, triangle, 0), edge_length(mesh, triangle, 1),
                   edge_length(mesh, triangle, 2)});
}

// Throws InputError if the triangle names a vertex that is not there. Complexity: O(1).
void require_valid_triangle(const TriangleMesh& mesh, TriangleId triangle);

// corners_of a triangle. Throws InputError as require_valid_triangle, and if a coordinate is not
// finite. Complexity: O(1).
std::array<Point, 3> finite_corners_of(const TriangleMesh& mesh, TriangleId triangle);

// Throws InputError if a triangle names a vertex that is not there, or if there are more triangles
// than 32-bit ids can name the edges of (2^32 / 3). Complexity: O(t).
void require_valid_triangles(const TriangleMesh& mesh);

// Rotates every triangle so that its smallest vertex id comes first, then sorts the triangles:
// equal surfaces become equal arrays. Orientation is kept.
// Precondition: triangles name vertices that are there. Complexity: O(t + v) for bounded valence,
// parallel.
void canonicalize_triangles(TriangleMesh& mesh, const Execution& execution = {});

}  // namespace cocoon
