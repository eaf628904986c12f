#include "update/model_index.h"

#include <algorithm>
#include <array>
#include <string>

#include "geom/errors.h"
#include "geom/triangle_projection.h"

namespace cocoon {

namespace {

// A closest point computed on a triangle may lie outside its box by rounding: boxes grow by this
// share of the largest coordinate.
constexpr double box_slack = 0x1p-44;

std::array<Point, 3> corners_of(const TriangleMesh& mesh, TriangleId t) {
  const Triangle& corners = mesh.triangles[t];
  return {mesh.points[corners[0]], mesh.points[corners[1]], mesh.points[corners[2]]};
}

std::array<Point, 3> sorted_corners(const TriangleMesh& mesh, TriangleId t) {
  std::array<Point, 3> corners = corners_of(mesh, t);
  std::sort(corners.begin(), corners.end());
  return corners;
}

const TriangleMesh& checked(const TriangleMesh& mesh) {
  if (mesh.triangles.empty()) {
    throw InputError("update: the model has no triangles; give a closed mesh or reconstruct one");
  }
  for (const TriangleId t : mesh.triangles.ids()) {
    for (const VertexId v : mesh.triangles[t]) {
      if (v.index() < mesh.points.size() && is_finite(mesh.points[v])) continue;
      throw InputError("update: triangle " + std::to_string(t.value) +
                       " of the model names vertex " + std::to_string(v.value) +
                       ", which is missing or not finite; repair the mesh");
    }
  }
  return mesh;
}

BoxTree facet_tree(const TriangleMesh& mesh) {
  std::vector<Box> boxes;
  boxes.reserve(mesh.triangles.size());
  double largest = 0;
  for (const TriangleId t : mesh.triangles.ids()) {
    const std::array<Point, 3> corners = corners_of(mesh, t);
    boxes.push_back(box_of(corners));
    for (const Point& p : corners) {
      largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    }
  }
  for (Box& box : boxes) box.enlarge(box_slack * largest);
  return BoxTree(boxes);
}

IdVector<TriangleId, std::uint32_t> components_of(const MeshAdjacency& adjacency) {
  constexpr std::uint32_t none = 0xFFFFFFFFU;
  IdVector<TriangleId, std::uint32_t> components(adjacency.neighbors.size(), none);
  std::uint32_t count = 0;
  std::vector<TriangleId> stack;
  for (const TriangleId seed : components.ids()) {
    if (components[seed] != none) continue;
    components[seed] = count;
    stack.assign(1, seed);
    while (!stack.empty()) {
      const TriangleId t = stack.back();
      stack.pop_back();
      for (const TriangleId next : adjacency.neighbors[t]) {
        if (next.is_none() || components[next] != none) continue;
        components[next] = count;
        stack.push_back(next);
      }
    }
    ++count;
  }
  return components;
}

std::vector<VertexId> used_vertices(const TriangleMesh& mesh, const MeshAdjacency& adjacency) {
  std::vector<VertexId> used;
  for (const VertexId v : mesh.points.ids()) {
    if (!adjacency.triangles_at(v).empty()) used.push_back(v);
  }
  return used;
}

std::vector<Point> points_of(const TriangleMesh& mesh, const std::vector<VertexId>& vertices) {
  std::vector<Point> points;
  points.reserve(vertices.size());
  for (const VertexId v : vertices) points.push_back(mesh.points[v]);
  return points;
}

}  // namespace

ModelIndex::ModelIndex(const TriangleMesh& mesh)
    : mesh_(&checked(mesh)),
      adjacency_(mesh_adjacency(mesh)),
      components_(components_of(adjacency_)),
      facets_(facet_tree(mesh)),
      used_vertices_(used_vertices(mesh, adjacency_)),
      vertices_(points_of(mesh, used_vertices_)) {
  normals_.reserve(mesh.triangles.size());
  for (const TriangleId t : mesh.triangles.ids()) {
    const auto [a, b, c] = corners_of(mesh, t);
    normals_.push_back(unit(cross(b - a, c - a)));
  }
}

Point ModelIndex::centroid(TriangleId t) const {
  const auto [a, b, c] = corners_of(*mesh_, t);
  return (a + b + c) / 3;
}

VertexId ModelIndex::nearest_vertex(const Point& p) const {
  return used_vertices_[vertices_.nearest(p).point.index()];
}

void ModelIndex::improve(const Point& p, TriangleId t, ClosestFacet& best) const {
  const ClosestPoint foot = closest_point_on_triangle(p, corners_of(*mesh_, t));
  const double squared = foot.squared_distance;
  if (squared > best.squared_distance) return;
  if (squared == best.squared_distance && !best.triangle.is_none()) {
    const auto own = sorted_corners(*mesh_, t);
    const auto others = sorted_corners(*mesh_, best.triangle);
    if (own > others || (own == others && t > best.triangle)) return;
  }
  best = {t, foot.point, squared};
}

}  // namespace cocoon
