#include "geom/mesh/weld_vertices.h"

namespace cocoon {

WeldedMesh weld_vertices(const TriangleMesh& mesh, std::span<const RepeatedPoint> repeated) {
  WeldedMesh result;
  result.welded = repeated.size();

  // Vertices: a repeated one becomes what the first of its place has become.
  result.vertex_of.reserve(mesh.points.size());
  auto next = repeated.begin();
  for (const VertexId v : mesh.points.ids()) {
    if (next != repeated.end() && next->point == v.value) {
      result.vertex_of.push_back(result.vertex_of[VertexId(next->first)]);
      ++next;
      continue;
    }
    result.vertex_of.push_back(VertexId(result.source.size()));
    result.source.push_back(v);
    result.mesh.points.push_back(mesh.points[v]);
  }

  // Triangles.
  result.mesh.triangles.reserve(mesh.triangles.size());
  for (Triangle t : mesh.triangles) {
    for (VertexId& corner : t) corner = result.vertex_of[corner];
    if (repeats_a_vertex(t)) {
      ++result.left_out_triangles;
    } else {
      result.mesh.triangles.push_back(t);
    }
  }
  return result;
}

}  // namespace cocoon
