#include "geom/triangle_mesh.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "geom/errors.h"
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

void require_valid_triangles(const TriangleMesh& mesh) {
  if (mesh.triangles.size() > TriangleId::none_value / 3) {
    throw InputError("mesh has " + std::to_string(mesh.triangles.size()) +
                     " triangles, more than 32-bit ids can name; split it");
  }
  for (const TriangleId t : mesh.triangles.ids()) require_valid_triangle(mesh, t);
}

void canonicalize_triangles(TriangleMesh& mesh) {
  for (Triangle& triangle : mesh.triangles) triangle = smallest_first(triangle);
  // A counting sort by the first vertex leaves a few triangles each to sort.
  std::vector<std::uint32_t> ends(mesh.points.size() + 1, 0);
  for (const Triangle& triangle : mesh.triangles) ++ends[triangle[0].index() + 1];
  std::partial_sum(ends.begin(), ends.end(), ends.begin());
  IdVector<TriangleId, Triangle> sorted(mesh.triangles.size());
  for (const Triangle& triangle : mesh.triangles) {
    sorted[TriangleId(ends[triangle[0].index()]++)] = triangle;
  }
  // Placing moved the begin of each group to its end.
  auto begin = sorted.begin();
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    const auto end = sorted.begin() + ends[v];
    std::sort(begin, end);
    begin = end;
  }
  mesh.triangles = std::move(sorted);
}

}  // namespace cocoon
