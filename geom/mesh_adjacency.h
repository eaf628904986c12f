// Which triangles meet at an edge and at a vertex of a mesh. Written for any triangle soup: open
// edges, edges with more than two triangles and inconsistent orientation are ordinary cases. A
// triangle that repeats a vertex has no edges; it only stands in the lists of its vertices.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "geom/id_vector.h"
#include "geom/ids.h"
#include "geom/triangle_mesh.h"

namespace cocoon {

// 3 * triangle + i: the side of a triangle opposite its corner i, which runs from corner i + 1 to
// corner i + 2 (modulo 3). The same numbering as the facets of a cell in a triangulation.
using HalfedgeId = Id<struct HalfedgeTag>;
// An undirected edge of a mesh, in the lexicographic order of (smaller, larger) vertex.
using EdgeId = Id<struct EdgeTag>;

constexpr HalfedgeId halfedge_of(TriangleId triangle, int i) {
  return HalfedgeId(3 * triangle.value + static_cast<std::uint32_t>(i));
}
constexpr TriangleId triangle_of(HalfedgeId halfedge) { return TriangleId(halfedge.value / 3); }
constexpr int corner_of(HalfedgeId halfedge) { return static_cast<int>(halfedge.value % 3); }

// The two ends of a side, in the direction in which its triangle runs through it.
inline std::array<VertexId, 2> ends_of(const TriangleMesh& mesh, HalfedgeId halfedge) {
  const Triangle& triangle = mesh.triangles[triangle_of(halfedge)];
  const std::size_t i = static_cast<std::size_t>(corner_of(halfedge));
  return {triangle[(i + 1) % 3], triangle[(i + 2) % 3]};
}

struct MeshAdjacency {
  // The triangle across side i (opposite corner i); `none` where there is no other
  // triangle or more than one: `halfedges_at(edge_of[side])` tells these apart and lists them.
  IdVector<TriangleId, std::array<TriangleId, 3>> neighbors;

  // (smaller, larger) vertex of each edge, sorted.
  IdVector<EdgeId, std::array<VertexId, 2>> edges;
  IdVector<HalfedgeId, EdgeId> edge_of;  // `none` in a triangle that repeats a vertex

  // CSR lists, each in increasing order of ids; use halfedges_at and triangles_at.
  std::vector<std::uint32_t> edge_begin;     // edges + 1
  std::vector<HalfedgeId> edge_halfedges;    // the sides at each edge
  std::vector<std::uint32_t> vertex_begin;   // points + 1
  std::vector<TriangleId> vertex_triangles;  // the triangles at each vertex, each once

  // The sides that lie on the edge: one at an open edge, two at an ordinary one, else more.
  std::span<const HalfedgeId> halfedges_at(EdgeId edge) const;
  // The triangles that have the vertex as a corner; empty for a vertex that no triangle uses.
  std::span<const TriangleId> triangles_at(VertexId vertex) const;
  // The edge between two vertices in either direction, or `none`. Complexity: O(log edges).
  EdgeId edge_between(VertexId a, VertexId b) const;
};

// Computes the adjacency of `mesh`. Throws InputError if a triangle names a vertex that is not
// there, or if there are more than 2^32 / 3 triangles.
// Complexity: O(t + v) and a sort of each vertex's few edges. Deterministic: a function of the
// mesh; all lists are in the order of ids.
MeshAdjacency mesh_adjacency(const TriangleMesh& mesh);

// The same without the edges, for those who only go from triangle to triangle: `neighbors` and
// triangles_at, for a third of the time. Everything else may be empty.
MeshAdjacency mesh_neighbors(const TriangleMesh& mesh);

// The neighbors alone. Precondition: no triangle repeats a vertex. Errors: as mesh_adjacency().
IdVector<TriangleId, std::array<TriangleId, 3>> neighbors_across_sides(const TriangleMesh& mesh);

// Fills in the lists of triangles at vertices alone. Precondition: triangles name vertices that are
// there. Complexity: O(t + v).
void list_triangles_at_vertices(const TriangleMesh& mesh, MeshAdjacency& adjacency);

}  // namespace cocoon
