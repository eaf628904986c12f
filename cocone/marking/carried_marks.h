// Marks without rounds: a side of the surface, carried over it from the hull.
#pragma once

#include <cstdint>
#include <vector>

#include "cocone/cell_marks.h"
#include "cocone/facets/linked_facets.h"

namespace cocoon {

struct CarriedMarks {
  static constexpr std::uint8_t unknown = 2;
  // Of each triangle at a visited vertex, on which side OUT is: 0, in the cell that numbers the
  // facet, 1, in the one behind.
  std::vector<std::uint8_t> out_side;
  // Visited vertices at whose stars the labels contradict each other, or their sides; increasing.
  std::vector<VertexId> disputed;
};

// What the rounds of mark_cells give where no two vertices disagree. The vertices that get their
// turn are those joined to the hull by triangles of the surface. A side of the surface, carried
// from triangle to triangle around them, labels the cells on both sides of it; cells that share a
// facet at such a vertex, off the surface, have the same label. Labels that meet all these
// conditions are those of the rounds: OUT is what hangs together with an infinite cell by such
// facets, IN what lies behind. Where they do not, as on any one-sided surface, some label is taken,
// and the vertices there are told: all cells of the others' stars have the label that the side
// carried to the vertex gives them. Parts of the surface that the hull does not see are begun at
// the first of the known cells (labels of finite cells, may be empty) that touches a good vertex of
// them. Fills in labels and visited vertices. `corner_at`: as in GoodVertices. Precondition: good
// vertices are known.
// Complexity: O(cells), in the order of memory; what concerns the surface alone is parallel.
// Source: Dey & Goswami 2003 (Tight Cocone, marking); the pass is ours, docs/stages/mark_cells.md.
CarriedMarks carry_marks(const Triangulation& triangulation, const LinkedFacets& surface,
                         const IdVector<VertexId, Halfedge>& corner_at,
                         const IdVector<CellId, CellLabel>& known, CellMarks& marks,
                         const Execution& execution = {});

// Calls visit(t) for each triangle of the surface around a good vertex once, in rotation, beginning
// with that of `corner`, the halfedge opposite to the vertex. Complexity: O(triangles there).
template <class Visit>
void for_each_triangle_around(const LinkedFacets& surface, Halfedge corner, Visit visit) {
  const std::uint32_t first = triangle_of_halfedge(corner);
  const VertexId v = surface.corners[first][corner_of_halfedge(corner)];
  Halfedge crossed = corner;
  std::size_t arrived = next_corner(corner_of_halfedge(crossed));
  do {
    const std::uint32_t t = triangle_of_halfedge(crossed);
    visit(t);
    std::size_t leaving = next_corner(arrived);
    if (surface.corners[t][leaving] == v) leaving = next_corner(leaving);
    crossed = surface.links[3 * t + static_cast<Halfedge>(leaving)];
    arrived = corner_of_halfedge(crossed);
  } while (triangle_of_halfedge(crossed) != first);
}

}  // namespace cocoon
