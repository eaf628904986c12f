// The halfedges of triangles, linked where they lie on the same edge.
//
// Use this to look at edges and who is on them: halfedge_links() for triangles that repeat no
// vertex, link_halfedges() for any mesh. For going from triangle to triangle alone see
// triangle_neighbors.h, for triangles at vertices triangles_at_vertices.h, for all neighborhoods of
// a large mesh linked_mesh.h.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "geom/execution.h"
#include "geom/id_vector.h"
#include "geom/ids.h"
#include "geom/triangle_mesh.h"

namespace cocoon {

// Halfedge 3 t + i is the edge opposite corner i of triangle t, in the direction in which t runs
// through it: from corner i + 1 to i + 2 (modulo 3). An integer, since it is computed with.
using Halfedge = std::uint32_t;
constexpr Halfedge no_halfedge = 0xFFFFFFFFU;

constexpr Halfedge halfedge_of(TriangleId triangle, std::size_t corner) {
  return 3 * triangle.value + static_cast<Halfedge>(corner);
}
constexpr std::uint32_t triangle_of_halfedge(Halfedge halfedge) { return halfedge / 3; }
constexpr std::uint32_t corner_of_halfedge(Halfedge halfedge) { return halfedge % 3; }

// The next and the one after next of 0, 1, 2 in turn: from tables of two bits each, since a branch
// on which corner it is cannot be foreseen.
constexpr std::size_t next_corner(std::size_t i) { return (0b00'10'01U >> (2 * i)) & 3U; }
constexpr std::size_t previous_corner(std::size_t i) { return (0b01'00'10U >> (2 * i)) & 3U; }

// Where a triangle has the vertex. Precondition: once.
constexpr std::size_t corner_at_vertex(const Triangle& triangle, VertexId v) {
  return (triangle[1] == v ? 1U : 0U) + (triangle[2] == v ? 2U : 0U);
}

// From where to where it runs, and the corner opposite.
inline std::array<VertexId, 2> ends_of_halfedge(const TriangleMesh& mesh, Halfedge halfedge) {
  const Triangle& triangle = mesh.triangles[TriangleId(triangle_of_halfedge(halfedge))];
  const std::size_t i = corner_of_halfedge(halfedge);
  return {triangle[next_corner(i)], triangle[previous_corner(i)]};
}
inline VertexId apex_of_halfedge(const TriangleMesh& mesh, Halfedge halfedge) {
  return mesh.triangles[TriangleId(triangle_of_halfedge(halfedge))][corner_of_halfedge(halfedge)];
}

// links[halfedge]: the next halfedge on the same edge, whatever their directions; those of an edge
// make a ring in ascending order (up to where it begins). So a halfedge linked to itself is the
// only one on its edge, and two linked to each other are what a manifold has everywhere. Halfedges
// between equal vertices (of a triangle that repeats one) are linked to themselves.
using HalfedgeLinks = OverwriteVector<Halfedge>;  // by halfedge

// Precondition: vertices are smaller than num_vertices; fewer than 2^32 / 3 triangles.
// Complexity: O(triangles + vertices), parallel over vertices. Deterministic.
HalfedgeLinks halfedge_links(std::span<const Triangle> triangles, std::size_t num_vertices,
                             const Execution& execution = {});

// The same of triangles that are grouped by their smallest vertices, in less time and memory:
// those of vertex v are begins[v] .. begins[v + 1] - 1, as sort_by_vertex() says. Precondition: no
// triangle repeats a vertex.
HalfedgeLinks halfedge_links(std::span<const Triangle> triangles,
                             std::span<const std::uint32_t> begins,
                             const Execution& execution = {});

// Exactly two triangles at the edge of the halfedge.
inline bool has_two_triangles(const HalfedgeLinks& links, Halfedge halfedge) {
  return links[halfedge] != halfedge && links[links[halfedge]] == halfedge;
}
// The smallest halfedge on the same edge.
inline Halfedge first_at_edge(const HalfedgeLinks& links, Halfedge halfedge) {
  Halfedge first = halfedge;
  for (Halfedge other = links[halfedge]; other != halfedge; other = links[other]) {
    first = std::min(first, other);
  }
  return first;
}
// Whether it is the largest one; links[halfedge] is then the smallest. Precondition: the ring
// ascends. Complexity: O(1): so a pass over all edges costs no more where many triangles share one.
inline bool is_last_at_edge(const HalfedgeLinks& links, Halfedge halfedge) {
  return links[halfedge] <= halfedge;
}
// Calls visit(other) for all halfedges on the edge, beginning with this one.
template <class Visit>
void for_each_at_edge(const HalfedgeLinks& links, Halfedge halfedge, Visit visit) {
  Halfedge other = halfedge;
  do {
    visit(other);
    other = links[other];
  } while (other != halfedge);
}

// The links of a mesh of which triangles may repeat a vertex: these have no edges, their halfedges
// are in no ring (no_halfedge).
struct HalfedgeRings {
  HalfedgeLinks links;

  bool has_edge(Halfedge halfedge) const { return links[halfedge] != no_halfedge; }
  // One triangle at the edge; the precondition of this and is_last is has_edge().
  bool is_open(Halfedge halfedge) const { return links[halfedge] == halfedge; }
  bool has_two_triangles(Halfedge halfedge) const {
    return has_edge(halfedge) && cocoon::has_two_triangles(links, halfedge);
  }
  // The largest on its edge: each edge has one. links[halfedge] is then the smallest.
  bool is_last(Halfedge halfedge) const { return is_last_at_edge(links, halfedge); }
};

// Throws InputError as require_valid_triangles(). Complexity: O(triangles + vertices), parallel.
HalfedgeRings link_halfedges(const TriangleMesh& mesh, const Execution& execution = {});

// Whether triangles have edges, and each edge is run through equally often in both directions: the
// mesh bounds a volume (MeshReport::balanced). Complexity: O(triangles), parallel.
bool is_balanced(const TriangleMesh& mesh, const HalfedgeRings& rings,
                 const Execution& execution = {});
// Overload for who needs no links. Throws InputError as link_halfedges().
bool is_balanced(const TriangleMesh& mesh, const Execution& execution = {});

// Those of the triangles whose flag is 0, numbered anew in their order. Complexity: O(triangles).
HalfedgeRings link_rest(const HalfedgeRings& rings, std::span<const std::uint8_t> removed);

}  // namespace cocoon
