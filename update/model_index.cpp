#include "update/model_index.h"

#include <array>
#include <string>
#include <vector>

#include "geom/errors.h"

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

}  // namespace

ModelIndex::ModelIndex(const TriangleMesh& mesh)
    : mesh_(&checked(mesh)),
      adjacency_(mesh_neighbors(mesh)),
      components_(components_of(adjacency_)) {}

Vec3 ModelIndex::normal(TriangleId t) const {
  const auto [a, b, c] = corners_of(*mesh_, t);
  return unit(cross(b - a, c - a));
}

Point ModelIndex::centroid(TriangleId t) const {
  const auto [a, b, c] = corners_of(*mesh_, t);
  return (a + b + c) / 3;
}

}  // namespace cocoon
