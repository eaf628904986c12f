#include "geom/mesh/used_vertices.h"

#include <cstddef>

namespace cocoon {

IdVector<VertexId, std::uint8_t> used_vertices(const TriangleMesh& mesh) {
  IdVector<VertexId, std::uint8_t> used(mesh.points.size(), 0);
  for (const Triangle& triangle : mesh.triangles) {
    for (const VertexId v : triangle) used[v] = 1;
  }
  return used;
}

IdVector<VertexId, VertexId> leave_out_unused(TriangleMesh& mesh) {
  const IdVector<VertexId, std::uint8_t> used = used_vertices(mesh);
  IdVector<VertexId, VertexId> now(mesh.points.size());
  std::size_t left = 0;
  for (const VertexId v : used.ids()) {
    if (used[v] == 0) continue;
    now[v] = VertexId(left++);
    mesh.points[now[v]] = mesh.points[v];
  }
  mesh.points.resize(left);
  for (Triangle& triangle : mesh.triangles) {
    for (VertexId& v : triangle) v = now[v];
  }
  return now;
}

}  // namespace cocoon
