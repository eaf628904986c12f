// Walking on the surface between two sides of the cells, from facet to facet.
#pragma once

#include <cstdint>

#include "delaunay/circulate.h"
#include "delaunay/triangulation.h"

namespace cocoon {

// The surface facet that follows f over its edge ab, through the cells on the side of f; seen from
// that side, too. Where more than two meet at the edge, those on one walk through that side follow
// each other. `out`: the side of each cell. Precondition: f is on the surface and has a and b.
// Complexity: O(cells at the edge).
inline FacetId next_surface_facet(const Triangulation& triangulation,
                                  const IdVector<CellId, std::uint8_t>& out, FacetId f, VertexId a,
                                  VertexId b) {
  const std::uint8_t side = out[cell_of(f)];
  f = other_facet_at_edge(triangulation, f, a, b);
  for (FacetId behind = triangulation.mirror(f); out[cell_of(behind)] == side;
       behind = triangulation.mirror(f)) {
    f = other_facet_at_edge(triangulation, behind, a, b);
  }
  return f;
}

// visit(f, end) for the surface facets around v, one after the other, from `first` on until it
// comes again or visit returns false: the walk goes on over the edge from v to `end`. Returns
// whether it came again. Precondition: `first` is on the surface and has v. Complexity: O(cells
// around v).
template <class Visit>
bool walk_around(const Triangulation& triangulation, const IdVector<CellId, std::uint8_t>& out,
                 VertexId v, FacetId first, Visit visit) {
  const auto corners = triangulation.facet_vertices(first);
  VertexId end = corners[0] == v ? corners[1] : corners[0];
  FacetId f = first;
  do {
    if (!visit(f, end)) return false;
    f = next_surface_facet(triangulation, out, f, v, end);
    end = third_vertex(triangulation, f, v, end);
  } while (f != first);
  return true;
}

}  // namespace cocoon
