#include "update/cloud_rim.h"

#include <algorithm>
#include <array>
#include <numbers>
#include <utility>

#include "cocone/boundary_loops.h"
#include "update/median.h"
#include "update/orient_components.h"

namespace cocoon {

namespace {

Vec3 area_vector(const TriangleMesh& mesh, TriangleId t) {
  const auto& [a, b, c] = mesh.triangles[t];
  const Point& origin = mesh.points[a];
  return 0.5 * cross(mesh.points[b] - origin, mesh.points[c] - origin);
}

// Unit normals of the vertices, weighted by area. The triangles must be oriented.
IdVector<VertexId, Vec3> vertex_normals(const TriangleMesh& mesh) {
  IdVector<VertexId, Vec3> sums(mesh.points.size());
  for (const TriangleId t : mesh.triangles.ids()) {
    const Vec3 area = area_vector(mesh, t);
    for (const VertexId v : mesh.triangles[t]) sums[v] = sums[v] + area;
  }
  for (Vec3& sum : sums) sum = unit(sum);
  return sums;
}

std::vector<double> component_areas(const TriangleMesh& mesh, const SurfaceComponents& parts) {
  std::vector<double> areas(parts.triangles.size(), 0.0);
  for (const TriangleId t : mesh.triangles.ids()) {
    areas[parts.component_of[t]] += norm(area_vector(mesh, t));
  }
  return areas;
}

double median_edge(const TriangleMesh& mesh) {
  std::vector<double> lengths;
  lengths.reserve(3 * mesh.triangles.size());
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      lengths.push_back(distance(mesh.points[t[i]], mesh.points[t[(i + 1) % 3]]));
    }
  }
  return median(lengths);
}

VertexId apex_of(const TriangleMesh& mesh, const BoundaryEdge& edge) {
  for (const VertexId v : mesh.triangles[edge.triangle]) {
    if (v != edge.from && v != edge.to) return v;
  }
  return edge.from;
}

// Position and direction of the loop's canonical start.
struct LoopStart {
  std::size_t index = 0;
  bool forward = true;
};

LoopStart canonical_start(const std::vector<Point>& points) {
  const std::size_t n = points.size();
  LoopStart best;
  auto second = [&](const LoopStart& s) -> const Point& {
    return points[s.forward ? (s.index + 1) % n : (s.index + n - 1) % n];
  };
  for (std::size_t i = 0; i < n; ++i) {
    for (const bool forward : {true, false}) {
      const LoopStart candidate{i, forward};
      const auto order = points[i] <=> points[best.index];
      if (order < 0 || (order == 0 && second(candidate) < second(best))) best = candidate;
    }
  }
  return best;
}

RimLoop make_loop(const TriangleMesh& mesh, const IdVector<VertexId, Vec3>& normals,
                  const std::vector<BoundaryEdge>& edges) {
  std::vector<Point> points;
  points.reserve(edges.size());
  for (const BoundaryEdge& edge : edges) points.push_back(mesh.points[edge.from]);
  const LoopStart start = canonical_start(points);

  RimLoop loop;
  const std::size_t n = edges.size();
  for (std::size_t k = 0; k < n; ++k) {
    // Backwards, the edge that leaves point i is the one that arrives there forwards.
    const std::size_t i = start.forward ? (start.index + k) % n : (start.index + n - k) % n;
    const BoundaryEdge& edge = edges[start.forward ? i : (i + n - 1) % n];
    loop.points.push_back(points[i]);
    loop.vertices.push_back(edges[i].from);
    loop.normals.push_back(normals[edges[i].from]);
    loop.apexes.push_back(mesh.points[apex_of(mesh, edge)]);
    loop.perimeter += distance(mesh.points[edge.from], mesh.points[edge.to]);
  }
  return loop;
}

bool is_pin_hole(const RimLoop& loop, double edge_length, double component_area,
                 const RimOptions& options) {
  const bool small = loop.size() < options.min_loop_edges ||
                     loop.perimeter < options.min_loop_perimeter * edge_length;
  const double disk_perimeter = 2 * std::sqrt(std::numbers::pi * component_area);
  return small && loop.perimeter < options.min_outline_share * disk_perimeter;
}

}  // namespace

CloudRim cloud_rim(const TriangleMesh& surface, const RimOptions& options) {
  // 1. Orient, so that every rim edge has a direction and every rim point a normal.
  TriangleMesh mesh = surface;
  const SurfaceComponents parts = orient_components(mesh);
  const IdVector<VertexId, Vec3> normals = vertex_normals(mesh);
  const std::vector<double> areas = component_areas(mesh, parts);
  const double edge_length = median_edge(mesh);

  CloudRim rim;
  rim.orientation_conflicts = parts.conflicts;
  const double min_triangles =
      options.min_component_share * static_cast<double>(mesh.triangles.size());
  auto is_debris = [&](std::uint32_t component) {
    return static_cast<double>(parts.triangles[component]) < min_triangles;
  };
  for (std::uint32_t c = 0; c < parts.triangles.size(); ++c) {
    if (!is_debris(c)) continue;
    ++rim.small_components;
    rim.discarded_triangles += parts.triangles[c];
  }

  // 2. Loops that are neither debris nor pin-holes, in canonical form.
  for (const std::vector<BoundaryEdge>& edges : boundary_loops(mesh)) {
    const std::uint32_t component = parts.component_of[edges.front().triangle];
    if (is_debris(component)) continue;
    RimLoop loop = make_loop(mesh, normals, edges);
    loop.component = component;
    if (is_pin_hole(loop, edge_length, areas[component], options)) {
      ++rim.pin_holes;
      continue;
    }
    rim.loops.push_back(std::move(loop));
  }
  std::sort(rim.loops.begin(), rim.loops.end(),
            [](const RimLoop& a, const RimLoop& b) { return a.points < b.points; });

  // 3. The spacing along the rim.
  std::vector<double> rim_edges;
  for (const RimLoop& loop : rim.loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      rim_edges.push_back(distance(loop.points[i], loop.points[loop.next(i)]));
    }
  }
  rim.spacing = rim_edges.empty() ? edge_length : median(rim_edges);
  return rim;
}

}  // namespace cocoon
