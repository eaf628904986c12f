#include "geom/changed_adjacency.h"

#include <array>
#include <cstddef>

#include "geom/large_pages.h"

namespace cocoon {
namespace {

using Neighbors = IdVector<TriangleId, std::array<TriangleId, 3>>;

// By how many corners the triangle is turned in its new place.
std::size_t turn_of(const Triangle& now, VertexId first_before) {
  return now[0] == first_before ? 0 : now[1] == first_before ? 1 : 2;
}

// The links between triangles that stay; others are none. False if there was an open side before.
bool copy_links(const TriangleMesh& mesh, const MeshBefore& before, Neighbors& neighbors) {
  for (const TriangleId t : before.mesh.triangles.ids()) {
    const std::array<TriangleId, 3>& old = before.adjacency.neighbors[t];
    if (old[0].is_none() || old[1].is_none() || old[2].is_none()) return false;
    const TriangleId now = before.triangle_map[t];
    if (now.is_none()) continue;
    const std::size_t turn =
        turn_of(mesh.triangles[now], before.vertex_map[before.mesh.triangles[t][0]]);
    for (std::size_t k = 0; k < 3; ++k) {
      neighbors[now][(k + turn) % 3] = before.triangle_map[old[k]];
    }
  }
  return true;
}

bool has_corner(const Triangle& triangle, VertexId v) {
  return triangle[0] == v || triangle[1] == v || triangle[2] == v;
}

// The one other triangle at the side; none if there is none or several.
TriangleId across(const TriangleMesh& mesh, const MeshAdjacency& adjacency, HalfedgeId side) {
  const auto [from, to] = ends_of(mesh, side);
  TriangleId found;
  for (const TriangleId t : adjacency.triangles_at(from)) {
    if (t == triangle_of(side) || !has_corner(mesh.triangles[t], to)) continue;
    if (!found.is_none()) return {};
    found = t;
  }
  return found;
}

}  // namespace

std::optional<ChangedAdjacency> changed_neighbors(const TriangleMesh& mesh,
                                                  const MeshBefore& before) {
  ChangedAdjacency result;
  MeshAdjacency& adjacency = result.adjacency;
  adjacency.neighbors.reserve(mesh.triangles.size());
  prefer_large_pages(adjacency.neighbors.raw());
  adjacency.neighbors.resize(mesh.triangles.size());
  if (!copy_links(mesh, before, adjacency.neighbors)) return {};
  list_triangles_at_vertices(mesh, adjacency);
  for (const TriangleId t : mesh.triangles.ids()) {
    bool at_seam = false;
    for (int i = 0; i < 3; ++i) {
      TriangleId& neighbor = adjacency.neighbors[t][static_cast<std::size_t>(i)];
      if (!neighbor.is_none()) continue;
      if (repeats_a_vertex(mesh.triangles[t])) return {};
      neighbor = across(mesh, adjacency, halfedge_of(t, i));
      if (neighbor.is_none() || repeats_a_vertex(mesh.triangles[neighbor])) return {};
      at_seam = true;
    }
    if (at_seam) result.seam.push_back(t);
  }
  return result;
}

}  // namespace cocoon
