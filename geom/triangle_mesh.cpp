#include "geom/triangle_mesh.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "geom/errors.h"
#include "geom/sort_by_vertex.h"
#include "geom/triangle_order.h"

namespace cocoon {

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
  for (const TriangleId t : mesh.triangles.ids()) require_valid_triangle(mesh, t);
}

void canonicalize_triangles(TriangleMesh& mesh, const Execution& execution) {
  // A counting sort by the first vertex leaves a few triangles each to sort.
  IdVector<TriangleId, Triangle> sorted;
  const std::vector<std::uint32_t> begins = sort_by_vertex(
      mesh.triangles.size(), mesh.points.size(), execution,
      [&](std::size_t count) { sorted.resize(count); },
      [&](std::size_t begin, std::size_t end, auto put) {
        for (const Triangle& given : mesh.triangles.span().subspan(begin, end - begin)) {
          const Triangle triangle = smallest_first(given);
          put(triangle[0], [&](std::uint32_t place) { sorted[TriangleId(place)] = triangle; });
        }
      });
  constexpr std::size_t vertices_per_chunk = std::size_t{1} << 14;
  parallel_chunks(execution, mesh.points.size(), vertices_per_chunk,
                  [&](std::size_t begin, std::size_t end) {
                    for (std::size_t v = begin; v < end; ++v) {
                      std::sort(sorted.begin() + begins[v], sorted.begin() + begins[v + 1]);
                    }
                  });
  mesh.triangles = std::move(sorted);
}

}  // namespace cocoon
