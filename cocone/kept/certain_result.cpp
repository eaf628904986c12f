#include "cocone/kept/certain_result.h"

#include <vector>

#include "geom/triangle_mesh.h"

namespace cocoon {
namespace {

// The vertices of the surface in the order of their first points, with the places that they have in
// it; none: not on the surface.
struct NumberedVertices {
  std::vector<PointId> first_points;
  IdVector<VertexId, VertexId> places;
};

NumberedVertices numbered_vertices(const CertainView& view) {
  NumberedVertices found;
  found.places.resize(view.delaunay.num_vertex_slots());
  for (const PointId p : view.vertex_of_point.ids()) {
    const VertexId v = view.vertex_of_point[p];
    if (!found.places[v].is_none() || !view.certified.has(v)) continue;
    found.places[v] = VertexId(found.first_points.size());
    found.first_points.push_back(p);
  }
  return found;
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
  const NumberedVertices vertices = numbered_vertices(view);
  for (const PointId p : vertices.first_points) {
    const VertexId v = view.vertex_of_point[p];
    result.mesh.points.push_back(points[p.index()]);
    result.point_of_vertex.push_back(p);
    result.normals.push_back(view.candidates.normal(v));
    result.boundary_sample.push_back(view.candidates.is_boundary(v) ? 1 : 0);
  }
  for (const auto& [a, b, c] : view.certified.triangles(view.delaunay.view())) {
    result.mesh.triangles.push_back({vertices.places[a], vertices.places[b], vertices.places[c]});
  }
  canonicalize_triangles(result.mesh);
  return result;
}

}  // namespace cocoon
