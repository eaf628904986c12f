#include "geom/mesh/changed_neighbors.h"

#include <cstddef>

#include "geom/arrays/large_pages.h"
#include "geom/mesh/halfedges.h"

namespace cocoon {
namespace {

// By how many corners the triangle is turned in its new place.
std::size_t turn_of(const Triangle& now, VertexId first_before) {
  return now[0] == first_before ? 0 : now[1] == first_before ? 1 : 2;
}

// The links between triangles that stay; others are none. False if there was an open edge before.
bool copy_links(const TriangleMesh& mesh, const MeshBefore& before, TriangleNeighbors& neighbors) {
  for (const TriangleId t : before.mesh.triangles.ids()) {
    const std::array<TriangleId, 3>& old = before.neighbors[t];
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

// The one other triangle at the halfedge; none if there is none or several.
TriangleId across(const TriangleMesh& mesh, const TrianglesAtVertices& at_vertices,
                  Halfedge halfedge) {
  const auto [from, to] = ends_of_halfedge(mesh, halfedge);
  TriangleId found;
  for (const TriangleId t : at_vertices[from]) {
    if (t.value == triangle_of_halfedge(halfedge) || !has_corner(mesh.triangles[t], to)) continue;
    if (!found.is_none()) return {};
    found = t;
  }
  return found;
}

}  // namespace

std::optional<ChangedNeighbors> changed_neighbors(const TriangleMesh& mesh,
                                                  const MeshBefore& before) {
  ChangedNeighbors result;
  TriangleNeighbors& neighbors = result.neighbors;
  neighbors.reserve(mesh.triangles.size());
  prefer_large_pages(neighbors.raw());
  neighbors.resize(mesh.triangles.size());
  if (!copy_links(mesh, before, neighbors)) return {};
  result.at_vertices = triangles_at_vertices(mesh);
  for (const TriangleId t : mesh.triangles.ids()) {
    bool at_seam = false;
    for (std::size_t i = 0; i < 3; ++i) {
      TriangleId& neighbor = neighbors[t][i];
      if (!neighbor.is_none()) continue;
      if (repeats_a_vertex(mesh.triangles[t])) return {};
      neighbor = across(mesh, result.at_vertices, halfedge_of(t, i));
      if (neighbor.is_none() || repeats_a_vertex(mesh.triangles[neighbor])) return {};
      at_seam = true;
    }
    if (at_seam) result.seam.push_back(t);
  }
  return result;
}

}  // namespace cocoon
