// Bowyer-Watson insertion of one point: find the cells whose circumsphere contains it, remove
// them, and fill the hole with the cells that join its border to the point.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "delaunay/cell_pool.h"
#include "delaunay/delaunay.h"
#include "geom/id_vector.h"
#include "geom/point.h"

namespace cocoon {

// A facet between a conflict cell and a cell that stays, with all that the new cell in its place
// needs: the conflict cell's slot may be overwritten before it is built.
struct CavityFacet {
  std::array<VertexId, 4> vertices;  // the conflict cell's, with the new vertex in place `apex`
  FacetId outer;                     // the facet as the cell outside numbers it
  int apex;
};

// Inserts points one after the other; holds the scratch memory that insertions share.
class CavityInserter {
 public:
  // `points` must outlive the inserter; ids of inserted vertices index it.
  CavityInserter(CellPool& pool, const IdVector<VertexId, Point>& points);

  // Inserts vertex v, whose point lies in conflict with cell `start` (the result of locate).
  // Precondition: the point is not equal to a vertex of the triangulation.
  // Returns a cell at v. Errors: InputError if the cells exceed their 30-bit numbering.
  // Complexity: O(size of the conflict zone).
  CellId insert(VertexId v, CellId start, DelaunayCounters& counters);

 private:
  bool in_conflict(const Cell& cell, const Point& p) const;
  void add_conflict(CellId c);
  std::size_t test_batch(std::size_t first, const Point& p);
  void find_conflict_zone(VertexId v, CellId start, DelaunayCounters& counters);
  void collect_border(VertexId v);
  void allocate_new_cells();
  void number_border_vertices();
  void fill_with_edge_table();
  void fill_with_sorted_edges();
  void build_cell(std::size_t border_index);

  CellPool& pool_;
  const IdVector<VertexId, Point>& points_;
  std::vector<CellId> conflict_cells_;  // the conflict zone, in breadth-first order
  std::vector<CellId> candidates_;      // cells next to conflict cells, in order of discovery
  std::vector<CavityFacet> border_;     // its boundary, one facet per new cell
  std::vector<CellId> new_cells_;       // parallel to border_
  IdVector<VertexId, std::uint8_t> local_id_;  // number of a border vertex, no_local_id elsewhere
  std::vector<VertexId> border_vertices_;
  std::vector<FacetId> edge_table_;  // facet of a new cell by (local id, local id) of its edge
};

}  // namespace cocoon
