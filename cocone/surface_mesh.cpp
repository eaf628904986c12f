#include "cocone/surface_mesh.h"

namespace cocoon {
namespace {

// Numbers the used vertices by their first input points.
IdVector<VertexId, VertexId> number_vertices(const Triangulation& triangulation,
                                             const VertexSet& used, SurfaceMesh& surface) {
  IdVector<VertexId, VertexId> number(triangulation.num_vertices());
  const IdVector<PointId, VertexId>& vertex_of_point = triangulation.vertex_of_point();
  for (const PointId p : vertex_of_point.ids()) {
    const VertexId v = vertex_of_point[p];
    if (used[v] == 0 || !number[v].is_none()) continue;
    number[v] = surface.mesh.points.push_back(triangulation.point(v));
    surface.point_of_vertex.push_back(p);
    surface.triangulation_vertex.push_back(v);
  }
  return number;
}

}  // namespace

SurfaceMesh surface_of(const Triangulation& triangulation, std::span<const FacetId> halves) {
  VertexSet used(triangulation.num_vertices(), 0);
  for (const FacetId f : halves) {
    for (const VertexId v : triangulation.facet_vertices(f)) used[v] = 1;
  }
  SurfaceMesh surface;
  const IdVector<VertexId, VertexId> number = number_vertices(triangulation, used, surface);
  surface.mesh.triangles.reserve(halves.size());
  for (const FacetId f : halves) {
    const auto [a, b, c] = triangulation.facet_vertices(f);
    surface.mesh.triangles.push_back({number[a], number[c], number[b]});
  }
  canonicalize_triangles(surface.mesh);
  return surface;
}

SurfaceMesh surface_between(const Triangulation& triangulation, const CellMarks& marks) {
  std::vector<FacetId> halves;
  for (const CellId c : triangulation.finite_cells()) {
    if (marks.reached[c] != 0) continue;
    for (int i = 0; i < 4; ++i) {
      const FacetId outside = triangulation.mirror(facet_id(c, i));
      if (marks.reached[cell_of(outside)] != 0) halves.push_back(outside);
    }
  }
  return surface_of(triangulation, halves);
}

}  // namespace cocoon
