#include "geom/triangle_mesh.h"

#include <algorithm>
#include <cstdint>
#include <string>

#include "geom/errors.h"
#include "geom/mesh/triangle_order.h"

namespace cocoon {

namespace {

// Without a branch for each corner.
bool names_vertices_there(const TriangleMesh& mesh) {
  std::uint32_t largest = 0;
  for (const Triangle& triangle : mesh.triangles) {
    for (const VertexId v : triangle) largest = std::max(largest, v.value);
  }
  return mesh.triangles.empty() || largest < mesh.points.size();
}

}  // namespace

void require_valid_triangle(const TriangleMesh& mesh, TriangleId triangle) {
  for (const VertexId v : mesh.triangles[triangle]) {
    if (v.index() < mesh.points.size()) continue;
    throw InputError("triangle " + std::to_string(triangle.value) + " names vertex " +
                     std::to_string(v.value) + " of a mesh with " +
                     std::to_string(mesh.points.size()) + " vertices; repair its indices");
  }
}

std::array<Point, 3> finite_corners_of(const TriangleMesh& mesh, TriangleId triangle) {
  require_valid_triangle(mesh, triangle);
  for (const VertexId v : mesh.triangles[triangle]) {
    if (is_finite(mesh.points[v])) continue;
    throw InputError("vertex " + std::to_string(v.value) +
                     " has a coordinate that is not finite; remove it from the mesh");
  }
  return corners_of(mesh, triangle);
}

void require_valid_triangles(const TriangleMesh& mesh) {
  if (mesh.triangles.size() > TriangleId::none_value / 3) {
    throw InputError("mesh has " + std::to_string(mesh.triangles.size()) +
                     " triangles, more than 32-bit ids can name; split it");
  }
  if (names_vertices_there(mesh)) return;
  for (const TriangleId t : mesh.triangles.ids()) require_valid_triangle(mesh, t);
}

void canonicalize_triangles(TriangleMesh& mesh, const Execution& execution) {
  mesh.triangles = canonical_triangles(
      mesh.triangles.size(), mesh.points.size(),
      [&](std::size_t t) { return mesh.triangles[TriangleId(t)]; }, execution);
}

}  // namespace cocoon
