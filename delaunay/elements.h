// All finite cells, facets and edges of a triangulation, each once.
#pragma once

#include "delaunay/circulate.h"
#include "delaunay/triangulation_view.h"

namespace cocoon {

// Calls visit(CellId) for every finite cell, in increasing order. Complexity: O(cells).
template <class Visit>
void for_each_finite_cell(const TriangulationView& triangulation, Visit visit) {
  for (const CellId c : triangulation.cell_slots()) {
    if (triangulation.is_finite_cell(c)) visit(c);
  }
}

// Calls visit(FacetId) for every finite facet, with its canonical id, in increasing order.
// Complexity: O(cells).
template <class Visit>
void for_each_finite_facet(const TriangulationView& triangulation, Visit visit) {
  for (const CellId c : triangulation.cell_slots()) {
    if (triangulation.is_free(c)) continue;
    for (int i = 0; i < 4; ++i) {
      const FacetId f = facet_id(c, i);
      if (triangulation.is_finite_facet(f) && triangulation.canonical(f) == f) visit(f);
    }
  }
}

// Calls visit(VertexId a, VertexId b, FacetId f) for every finite edge, a < b, f a facet at it for
// for_each_facet_around_edge. Complexity: O(cells * cells around an edge).
template <class Visit>
void for_each_finite_edge(const TriangulationView& triangulation, Visit visit) {
  const auto visit_once = [&](CellId c, int i, int j) {
    const VertexId a = triangulation.vertex(c, i);
    const VertexId b = triangulation.vertex(c, j);
    // The edge is visited from the first of its finite cells.
    const FacetId start = facet_id(c, i == 0 ? (j == 1 ? 2 : 1) : 0);
    bool is_first = true;
    for_each_facet_around_edge(triangulation, start, a, b, [&](FacetId f) {
      is_first = is_first && (cell_of(f) >= c || triangulation.is_infinite(cell_of(f)));
    });
    if (is_first) visit(std::min(a, b), std::max(a, b), start);
  };
  for_each_finite_cell(triangulation, [&](CellId c) {
    for (int i = 0; i < 4; ++i) {
      for (int j = i + 1; j < 4; ++j) visit_once(c, i, j);
    }
  });
}

}  // namespace cocoon
