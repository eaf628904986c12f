#include "update/cloud_rim.h"

#include <numbers>
#include <utility>

#include "cocone/orient_surface.h"
#include "geom/median.h"

namespace cocoon {

namespace {

// Unit normals of the vertices, weighted by area. The triangles must be oriented.
IdVector<VertexId, Vec3> vertex_normals(const TriangleMesh& mesh) {
  IdVector<VertexId, Vec3> sums(mesh.points.size());
  for (const auto& [a, b, c] : mesh.triangles) {
    const Point& origin = mesh.points[a];
    const Vec3 twice_area = cross(mesh.points[b] - origin, mesh.points[c] - origin);
    for (const VertexId v : {a, b, c}) sums[v] = sums[v] + twice_area;
  }
  for (Vec3& sum : sums) sum = unit(sum);
  return sums;
}

VertexId apex_of(const TriangleMesh& mesh, const BoundaryEdge& edge) {
  for (const VertexId v : mesh.triangles[edge.triangle]) {
    if (v != edge.from && v != edge.to) return v;
  }
  return edge.from;
}

RimLoop make_loop(const TriangleMesh& mesh, const IdVector<VertexId, Vec3>& normals,
                  const BoundaryLoop& boundary) {
  RimLoop loop;
  loop.perimeter = boundary.perimeter;
  for (const BoundaryEdge& edge : boundary.edges) {
    loop.points.push_back(mesh.points[edge.from]);
    loop.apexes.push_back(mesh.points[apex_of(mesh, edge)]);
    loop.normals.push_back(normals[edge.from]);
    loop.vertices.push_back(edge.from);
  }
  return loop;
}

// The perimeter of a disk with the area of the loop's component, taken to consist of equilateral
// triangles with the median edge.
double disk_perimeter(const BoundaryLoop& loop, double median_edge) {
  const double triangle = 0.25 * std::sqrt(3.0) * median_edge * median_edge;
  const double area = static_cast<double>(loop.component_triangles) * triangle;
  return 2 * std::sqrt(std::numbers::pi * area);
}

}  // namespace

CloudRim cloud_rim(const TriangleMesh& surface, const RimOptions& options) {
  return cloud_rim(surface, mesh_adjacency(surface), options);
}

CloudRim cloud_rim(const TriangleMesh& surface, const MeshAdjacency& adjacency,
                   const RimOptions& options) {
  TriangleMesh mesh = surface;
  // So that the normals around a loop agree.
  const bool flipped = orient_surface(mesh, adjacency).flipped > 0;
  const IdVector<VertexId, Vec3> normals = vertex_normals(mesh);
  const BoundaryLoops boundary =
      boundary_loops(mesh, flipped ? mesh_adjacency(mesh) : adjacency, options.loops);

  CloudRim rim;
  rim.small_components = boundary.small_components;
  rim.non_orientable = boundary.non_orientable;
  rim.median_edge = boundary.median_edge;
  std::vector<double> edge_lengths;
  for (const BoundaryLoop& loop : boundary.loops) {
    const double outline = options.min_outline_share * disk_perimeter(loop, boundary.median_edge);
    if (loop.pin_hole && loop.perimeter < outline) {
      ++rim.pin_holes;
      rim.pin_hole_loops.push_back(make_loop(mesh, normals, loop));
      continue;
    }
    rim.loops.push_back(make_loop(mesh, normals, loop));
    for (const BoundaryEdge& edge : loop.edges) {
      edge_lengths.push_back(distance(mesh.points[edge.from], mesh.points[edge.to]));
    }
  }
  rim.spacing = edge_lengths.empty() ? boundary.median_edge : median(std::move(edge_lengths));
  return rim;
}

}  // namespace cocoon
