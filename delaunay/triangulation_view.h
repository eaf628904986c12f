// Reading access to the cells of a triangulation, frozen or growing.
#pragma once

#include "delaunay/triangulation.h"

namespace cocoon {

// Two pointers: pass it by value or const reference. Names points and cells as Triangulation does,
// but a growing triangulation also has free cell slots, and its infinite cells lie anywhere: ask
// is_free and is_infinite. Valid until the triangulation changes. Complexity: O(1) each.
class TriangulationView {
 public:
  // Implicit, so that whatever reads a view takes a triangulation.
  TriangulationView(const Triangulation& triangulation)
      : TriangulationView(triangulation.points(), triangulation.cell_records()) {}
  // Both must outlive the view.
  TriangulationView(const IdVector<VertexId, Point>& points, const IdVector<CellId, Cell>& cells)
      : points_(&points), cells_(&cells) {}

  const IdVector<VertexId, Point>& points() const { return *points_; }
  const Point& point(VertexId v) const { return (*points_)[v]; }
  const IdVector<CellId, Cell>& cell_records() const { return *cells_; }
  const Cell& cell(CellId c) const { return (*cells_)[c]; }
  IdRange<CellId> cell_slots() const { return cells_->ids(); }
  bool is_free(CellId c) const { return (*cells_)[c].vertices[0].is_none(); }
  bool is_infinite(CellId c) const { return cocoon::is_infinite((*cells_)[c]); }
  bool is_finite_cell(CellId c) const { return !is_free(c) && !is_infinite(c); }

  VertexId vertex(CellId c, int i) const { return vertex_of(*cells_, c, i); }
  FacetId mirror(FacetId f) const { return mirror_of(*cells_, f); }
  CellId neighbor(CellId c, int i) const { return cell_of(mirror(facet_id(c, i))); }
  FacetId canonical(FacetId f) const { return canonical_of(*cells_, f); }
  bool is_finite_facet(FacetId f) const { return !is_infinite(cell_of(f)) || index_of(f) == 3; }
  // The three vertices, ordered so that the normal points out of cell_of(f).
  Triangle facet_vertices(FacetId f) const {
    return cocoon::facet_vertices((*cells_)[cell_of(f)], index_of(f));
  }

 private:
  const IdVector<VertexId, Point>* points_;
  const IdVector<CellId, Cell>* cells_;
};

}  // namespace cocoon
