#include "update/cloud_rim.h"

#include <cstdint>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

#include "cocone/orient_surface.h"
#include "geom/arrays/median.h"
#include "geom/mesh/edge_components.h"
#include "update/cloud/area_normals.h"
#include "update/stage_options.h"

namespace cocoon {

namespace {

// At the points of all loops, one loop after the other: of the triangles of the loop's part.
std::vector<Vec3> normals_at(const std::vector<BoundaryLoop>& loops, const TriangleMesh& mesh,
                             const EdgeComponents& components) {
  std::vector<VertexOfPart> corners;
  for (const BoundaryLoop& loop : loops) {
    for (const BoundaryEdge& edge : loop.edges) {
      corners.push_back({edge.from, components.component_of[edge.triangle.index()]});
    }
  }
  return area_normals_of_parts(mesh, components.component_of, corners);
}

// The same of a loop on a one-sided part, where triangles have no common orientation: of the
// triangles at the loop alone, which hang together like an annulus.
void take_normals_of_edges(RimLoop& loop) {
  const std::size_t size = loop.size();
  std::vector<Vec3> of_edges;
  for (std::size_t i = 0; i < size; ++i) {
    of_edges.push_back(
        cross(loop.points[loop.next(i)] - loop.points[i], loop.apexes[i] - loop.points[i]));
  }
  for (std::size_t i = 0; i < size; ++i) {
    loop.normals[i] = unit(of_edges[i] + of_edges[i > 0 ? i - 1 : size - 1]);
  }
}

VertexId apex_of(const TriangleMesh& mesh, const BoundaryEdge& edge) {
  for (const VertexId v : mesh.triangles[edge.triangle]) {
    if (v != edge.from && v != edge.to) return v;
  }
  return edge.from;
}

RimLoop make_loop(const TriangleMesh& mesh, std::span<const Vec3> normals,
                  const BoundaryLoop& boundary, bool one_sided) {
  RimLoop loop;
  loop.one_sided = one_sided;
  loop.perimeter = boundary.perimeter;
  loop.component = boundary.component;
  loop.normals.assign(normals.begin(), normals.end());
  for (const BoundaryEdge& edge : boundary.edges) {
    loop.points.push_back(mesh.points[edge.from]);
    loop.apexes.push_back(mesh.points[apex_of(mesh, edge)]);
    loop.vertices.push_back(edge.from);
    loop.triangles.push_back(edge.triangle);
  }
  if (one_sided) take_normals_of_edges(loop);
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
  return cloud_rim(surface, link_halfedges(surface), options);
}

CloudRim cloud_rim(const TriangleMesh& surface, const HalfedgeRings& rings,
                   const RimOptions& options) {
  require_options("cloud_rim", options);
  TriangleMesh mesh = surface;
  // So that the normals around a loop agree.
  const EdgeComponents components = edge_components(mesh, rings);
  const bool flipped = orient_surface(mesh, components).flipped > 0;
  const BoundaryLoops boundary =
      boundary_loops(mesh, flipped ? link_halfedges(mesh) : rings, components, options.loops);
  const std::vector<Vec3> normals = normals_at(boundary.loops, mesh, components);

  const auto is_one_sided = [&](const BoundaryLoop& loop) {
    const std::size_t t = loop.edges.front().triangle.index();
    return components.components[components.component_of[t]].is_contradictory;
  };
  CloudRim rim;
  rim.small_components = boundary.small_components;
  rim.non_orientable = boundary.non_orientable;
  rim.median_edge = boundary.median_edge;
  std::vector<double> edge_lengths;
  auto of_loop = normals.begin();
  for (const BoundaryLoop& loop : boundary.loops) {
    const std::span<const Vec3> there(of_loop, loop.edges.size());
    of_loop += static_cast<std::ptrdiff_t>(loop.edges.size());
    RimLoop made = make_loop(mesh, there, loop, is_one_sided(loop));
    const double outline = options.min_outline_share * disk_perimeter(loop, boundary.median_edge);
    if (loop.pin_hole && loop.perimeter < outline) {
      ++rim.pin_holes;
      rim.pin_hole_loops.push_back(std::move(made));
      continue;
    }
    rim.loops.push_back(std::move(made));
    for (const BoundaryEdge& edge : loop.edges) {
      edge_lengths.push_back(distance(mesh.points[edge.from], mesh.points[edge.to]));
    }
  }
  rim.spacing = edge_lengths.empty() ? boundary.median_edge : median(std::move(edge_lengths));
  return rim;
}

CloudRim scaled(CloudRim rim, double factor) {
  rim.spacing *= factor;
  rim.median_edge *= factor;
  for (std::vector<RimLoop>* loops : {&rim.loops, &rim.pin_hole_loops}) {
    for (RimLoop& loop : *loops) {
      for (Point& p : loop.points) p = factor * p;
      for (Point& p : loop.apexes) p = factor * p;
      loop.perimeter *= factor;
    }
  }
  return rim;
}

}  // namespace cocoon
