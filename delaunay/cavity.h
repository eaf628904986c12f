// Bowyer-Watson insertion of one point: find the cells whose circumsphere contains it, remove
// them, and fill the hole with the cells that join its border to the point.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "delaunay/cell_pool.h"
#include "delaunay/delaunay.h"
#include "delaunay/scratch_list.h"
#include "geom/id_vector.h"
#include "geom/point.h"

namespace cocoon {

// A facet between a conflict cell and a cell that stays, with all that the new cell in its place
// needs: the conflict cell's slot may be overwritten before it is built.
struct CavityFacet {
  std::array<VertexId, 4> vertices;       // the conflict cell's, with the new vertex at `apex`
  std::array<std::uint8_t, 4> local_ids;  // of the border vertices, see describe_border_facet
  FacetId outer;                          // the facet as the cell outside numbers it
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
  void find_conflict_zone(VertexId v, CellId start);
  void collect_candidates(CellId conflict_cell);
  std::size_t test_candidates(std::size_t first, const Point& p);
  void collect_border(VertexId v);
  void describe_border_facet(FacetId facet, VertexId v);
  void allocate_new_cells();
  void build_cell(std::size_t border_index);
  void fill_with_edge_table();
  void fill_with_sorted_edges();

  CellPool& pool_;
  const IdVector<VertexId, Point>& points_;
  ScratchList<CellId> conflict_cells_;  // the conflict zone, in breadth-first order
  ScratchList<CellId> candidates_;      // cells next to conflict cells, in order of discovery
  ScratchList<FacetId> border_facets_;  // facets of the zone's border, seen from inside
  ScratchList<CavityFacet> border_;     // the same, with what the new cells need
  ScratchList<CellId> new_cells_;       // parallel to border_
  IdVector<VertexId, std::uint8_t> local_id_;  // number of a border vertex, no_local_id elsewhere
  ScratchList<VertexId> border_vertices_;      // as entries of local_id_
  std::vector<FacetId> edge_table_;  // facet of a new cell by (local id, local id) of its edge
};

}  // namespace cocoon
