// What marking and peel tell of the cells, and of the vertices that told it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "cocone/facet_set.h"
#include "cocone/marking/cell_label.h"
#include "delaunay/triangulation.h"
#include "geom/id_vector.h"

namespace cocoon {

struct CellMarks {
  IdVector<CellId, CellLabel> labels;
  VertexSet good;                // vertices that may tell the sides of the surface apart
  VertexSet visited;             // good vertices that have done so
  std::vector<VertexId> folded;  // closed umbrellas at folds or creases (umbrella.h); increasing
  // Labels told beforehand (known_labels.h); empty if there are none, or if they were not asked
  // for.
  IdVector<CellId, CellLabel> known;
  // After peel_cells: 1 = reached from infinity or in a kept hollow. The body: finite cells with 0.
  IdVector<CellId, std::uint8_t> reached;
  // After peel_cells, empty if there are no conflicts up to then: 1 = a good vertex whose cells are
  // not OUT on one side of the surface and IN (or unmarked) on the other.
  VertexSet contradicted;

  std::size_t good_vertices = 0;
  std::size_t visited_vertices = 0;
  // Closed umbrellas that known cells contradict, or that mark_undoubted_cells() doubts: not good.
  std::size_t refuted_vertices = 0;
  std::size_t rounds = 0;          // 0: no two vertices disagreed, one pass decided
  std::size_t known_cells = 0;     // that had their labels before the rounds
  std::size_t conflicts = 0;       // halves, or cells, that were told both (mark_cells.h)
  std::size_t deferred_seeds = 0;  // of peel_cells
  std::size_t poor_cells = 0;      // of peel_cells: cells without a good vertex
};

// Whether a vertex of a finite cell is in the set. O(1).
inline bool has_vertex_in(const VertexSet& set, const Cell& cell) {
  const auto& [v0, v1, v2, v3] = cell.vertices;
  return (set[v0] | set[v1] | set[v2] | set[v3]) != 0;
}

// Whether no vertex of a finite cell is good: none can tell on which side the cell is. O(1).
inline bool is_poor(const Triangulation& triangulation, const VertexSet& good, CellId c) {
  return !has_vertex_in(good, triangulation.cell(c));
}

// Whether a good vertex has not told the sides of the surface apart. O(1).
inline bool is_unvisited(const CellMarks& marks, VertexId v) {
  return marks.good[v] != 0 && marks.visited[v] == 0;
}

// Whether it is told beforehand on which side a finite cell is: nothing else is to decide that.
// O(1).
inline bool is_known(const CellMarks& marks, CellId c) {
  return !marks.known.empty() && marks.known[c] != CellLabel::unmarked;
}

// Whether a good vertex is contradicted by labels around it. O(1).
inline bool is_contradicted(const CellMarks& marks, VertexId v) {
  return marks.conflicts != 0 && marks.contradicted[v] != 0;
}

}  // namespace cocoon
