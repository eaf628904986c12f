#include "cocone/kept/certain_result.h"

#include <utility>

#include "geom/triangle_mesh.h"

namespace cocoon {
namespace {

// What is certified by mesh vertices, in canonical order.
IdVector<TriangleId, Triangle> certain_triangles(const CertainView& view) {
  IdVector<VertexId, VertexId> number(view.delaunay.num_vertex_slots());
  std::size_t count = 0;
  for (const VertexId v : view.vertex_of_point) {
    if (number[v].is_none() && view.certified.has(v)) number[v] = VertexId(count++);
  }
  TriangleMesh mesh;
  mesh.points.resize(count);
  for (const auto& [a, b, c] : view.certified.triangles(view.delaunay.view())) {
    mesh.triangles.push_back({number[a], number[b], number[c]});
  }
  canonicalize_triangles(mesh);
  return std::move(mesh.triangles);
}

}  // namespace

ReconstructResult certain_counts(const CertainView& view, std::size_t points) {
  ReconstructResult result;
  result.points = points;
  result.vertices = view.delaunay.num_vertices();
  result.duplicates = points - result.vertices;
  result.tetrahedra = view.candidates.num_finite_cells();
  view.candidates.count(result.counters);
  view.certified.count(result.counters);
  result.unused_points = result.vertices - view.certified.num_vertices();
  return result;
}

ReconstructResult certain_result(const CertainView& view, Points points) {
  ReconstructResult result = certain_counts(view, points.size());
  VertexSet listed(view.delaunay.num_vertex_slots(), 0);
  for (const PointId p : view.vertex_of_point.ids()) {
    const VertexId v = view.vertex_of_point[p];
    if (listed[v] != 0 || !view.certified.has(v)) continue;
    listed[v] = 1;
    result.mesh.points.push_back(points[p.index()]);
    result.point_of_vertex.push_back(p);
    result.normals.push_back(view.candidates.normal(v));
    result.boundary_sample.push_back(view.candidates.is_boundary(v) ? 1 : 0);
  }
  result.mesh.triangles = certain_triangles(view);
  return result;
}

}  // namespace cocoon
