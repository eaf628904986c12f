// Which sides of triangles lie on one edge, as rings of links: the leanest adjacency, for millions
// of triangles. geom/mesh_adjacency.h gives more, at a price.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "geom/execution.h"
#include "geom/id_vector.h"
#include "geom/ids.h"
#include "geom/triangle_mesh.h"

namespace cocoon {

// Side 3 t + i lies opposite corner i of triangle t and runs from corner i + 1 to i + 2 (modulo 3).
using SideId = std::uint32_t;
using SideLinks = OverwriteVector<SideId>;  // by side

constexpr std::uint32_t triangle_of_side(SideId side) { return side / 3; }
constexpr std::uint32_t corner_of_side(SideId side) { return side % 3; }

// The next and the one after next of 0, 1, 2 in turn: from tables of two bits each, since a branch
// on which corner it is cannot be foreseen.
constexpr std::size_t next_corner(std::size_t i) { return (0b00'10'01U >> (2 * i)) & 3U; }
constexpr std::size_t previous_corner(std::size_t i) { return (0b01'00'10U >> (2 * i)) & 3U; }

// Where a triangle has the vertex. Precondition: once.
constexpr std::size_t corner_at_vertex(const Triangle& triangle, VertexId v) {
  return (triangle[1] == v ? 1U : 0U) + (triangle[2] == v ? 2U : 0U);
}

// links[side]: the next side on the same edge, whatever their directions; the sides of an edge make
// a ring in ascending order (up to where it begins). So a side linked to itself is the only one on
// its edge, and two sides linked to each other are what a manifold has everywhere. Sides between
// equal vertices (of a triangle that repeats one) are linked to themselves. Precondition: vertices
// are smaller than num_vertices; fewer than 2^32 / 3 triangles. Complexity: O(triangles +
// vertices), parallel over vertices. Deterministic.
SideLinks side_links(std::span<const Triangle> triangles, std::size_t num_vertices,
                     const Execution& execution = {});

// The same of triangles that are grouped by their smallest vertices, in less time and memory:
// those of vertex v are begins[v] .. begins[v + 1] - 1, as sort_by_vertex() says. Precondition: no
// triangle repeats a vertex.
SideLinks side_links(std::span<const Triangle> triangles, std::span<const std::uint32_t> begins,
                     const Execution& execution = {});

}  // namespace cocoon
