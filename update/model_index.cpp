#include "update/model_index.h"

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "geom/changed_adjacency.h"
#include "geom/equal_points.h"
#include "geom/errors.h"
#include "geom/zeroed_array.h"

namespace cocoon {

namespace {

std::array<Point, 3> corners_of(const TriangleMesh& mesh, TriangleId t) {
  const Triangle& corners = mesh.triangles[t];
  return {mesh.points[corners[0]], mesh.points[corners[1]], mesh.points[corners[2]]};
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

// Empty if all triangles are of one component.
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
  if (count <= 1) components = {};
  return components;
}

// Whether one can go from each of the triangles, all different, to each other one within them.
bool hang_together(std::span<const TriangleId> triangles, const MeshAdjacency& adjacency) {
  if (triangles.empty()) return true;
  ZeroedArray<TriangleId, std::uint8_t> open(adjacency.neighbors.size());  // and not reached yet
  for (const TriangleId t : triangles) open[t] = 1;
  open[triangles[0]] = 0;
  std::size_t count = 1;
  std::vector<TriangleId> stack(1, triangles[0]);
  while (!stack.empty()) {
    const TriangleId t = stack.back();
    stack.pop_back();
    for (const TriangleId next : adjacency.neighbors[t]) {
      if (next.is_none() || open[next] == 0) continue;
      open[next] = 0;
      ++count;
      stack.push_back(next);
    }
  }
  return count == triangles.size();
}

bool all_differ(Points points) { return repeated_points(points).empty(); }

}  // namespace

ModelIndex::ModelIndex(const TriangleMesh& mesh)
    : mesh_(&checked(mesh)),
      adjacency_(mesh_neighbors(mesh)),
      components_(components_of(adjacency_)),
      distinct_points_(all_differ(mesh.points.span())) {}

ModelIndex::ModelIndex(const TriangleMesh& mesh, const IndexBefore& before) : mesh_(&mesh) {
  const MeshChange& change = before.change;
  std::optional<ChangedAdjacency> changed = changed_neighbors(
      mesh, {before.mesh, before.index.adjacency_, change.vertex_map, change.triangle_map});
  if (!changed) {
    *this = ModelIndex(mesh);
    return;
  }
  adjacency_ = std::move(changed->adjacency);
  // From a triangle that stayed one comes, within those that stayed, to one that went, hence to the
  // seam: if that hangs together so does all.
  const bool connected = before.index.is_connected() &&
                         (change.added.empty() || !change.removed.empty()) &&
                         hang_together(changed->seam, adjacency_);
  if (!connected) components_ = components_of(adjacency_);
  distinct_points_ = before.distinct_points || all_differ(mesh.points.span());
}

Vec3 ModelIndex::normal(TriangleId t) const {
  const auto [a, b, c] = corners_of(*mesh_, t);
  return unit(cross(b - a, c - a));
}

Point ModelIndex::centroid(TriangleId t) const {
  const auto [a, b, c] = corners_of(*mesh_, t);
  return (a + b + c) / 3;
}

}  // namespace cocoon
