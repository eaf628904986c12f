// The sides of a mesh, linked where they lie on the same edge: the adjacency of those who walk from
// triangle to triangle and look at edges, at a third of the price of MeshAdjacency.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "geom/ids.h"
#include "geom/side_links.h"
#include "geom/triangle_mesh.h"

namespace cocoon {

// A triangle that repeats a vertex has no edges: its sides are in no ring, and has_edge() is false.
struct LinkedSides {
  SideLinks links;  // rings in ascending order, as in side_links.h

  static constexpr SideId no_side = 0xFFFFFFFFU;

  bool has_edge(SideId side) const { return links[side] != no_side; }
  // One triangle at the edge of the side; exactly two; the precondition of others is has_edge().
  bool is_open(SideId side) const { return links[side] == side; }
  bool is_two_sided(SideId side) const {
    return has_edge(side) && links[side] != side && links[links[side]] == side;
  }
  // The smallest of the sides on its edge: each edge has one.
  bool is_first(SideId side) const {
    SideId other = links[side];
    while (other > side) other = links[other];
    return other == side;
  }
  // Calls visit(other) for all sides on the edge, beginning with this one.
  template <class Visit>
  void for_each_at_edge(SideId side, Visit visit) const {
    SideId other = side;
    do {
      visit(other);
      other = links[other];
    } while (other != side);
  }
};

// The two ends of a side, in the direction in which its triangle runs through it.
inline std::array<VertexId, 2> ends_of_side(const TriangleMesh& mesh, SideId side) {
  const Triangle& triangle = mesh.triangles[TriangleId(triangle_of_side(side))];
  const std::size_t i = corner_of_side(side);
  return {triangle[next_corner(i)], triangle[previous_corner(i)]};
}
inline VertexId apex_of_side(const TriangleMesh& mesh, SideId side) {
  return mesh.triangles[TriangleId(triangle_of_side(side))][corner_of_side(side)];
}

// Throws InputError as require_valid_triangles(). Complexity: O(triangles + vertices).
LinkedSides link_sides(const TriangleMesh& mesh);

// Those of the triangles whose flag is 0, numbered anew in their order. Complexity: O(triangles).
LinkedSides link_rest(const LinkedSides& sides, std::span<const std::uint8_t> removed);

}  // namespace cocoon
