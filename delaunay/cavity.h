// Bowyer-Watson insertion of one point: find the cells whose circumsphere contains it, remove
// them, and fill the hole with the cells that join its border to the point.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "delaunay/cell_pool.h"
#include "delaunay/conflict_batch.h"
#include "delaunay/delaunay.h"
#include "delaunay/scratch_list.h"
#include "geom/id_vector.h"
#include "geom/point.h"

namespace cocoon {

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

  // Of the last insertion: the facets opposite the new vertex, one of each new cell, and the slots
  // of the cells that are gone.
  const ScratchList<FacetId>& star() const { return star_; }
  const ScratchList<CellId>& removed_cells() const { return conflict_cells_; }

  // To be called after `points` was extended. Amortized O(1) per vertex.
  void make_room_for_points();

  // To be called after `points` was filled with other points. Complexity: O(n).
  void read_points_again();

 private:
  using LocalIds = std::array<std::uint8_t, 3>;  // of a border facet's corners, as facet_corners

  bool in_conflict(const Cell& cell, const Point& p) const;
  bool in_conflict_on_sphere(const Cell& cell, const Point& p) const;
  void find_conflict_zone(VertexId v, CellId start, DelaunayCounters& counters);
  void collect_candidates(CellId conflict_cell);
  std::size_t test_candidates(std::size_t first, const Point& p, DelaunayCounters& counters);
  void collect_border();
  void grow_pool(std::size_t count);
  void build_star(VertexId v);
  void link_by_edge_table(unsigned shift);
  void link_by_sorted_edges();
  void unmark_cells();
  void release_conflict_zone();

  CellPool& pool_;
  const IdVector<VertexId, Point>& points_;
  ConflictFilter filter_;
  ScratchList<CellId> conflict_cells_;     // the conflict zone, in breadth-first order
  ScratchList<CellId> candidates_;         // cells next to conflict cells, in order of discovery
  ScratchList<FacetId> border_;            // facets of the zone's border, seen from inside
  ScratchList<FacetId> star_;              // for each, the new cell's facet there, seen from inside
  ScratchList<LocalIds> local_corners_;    // for each, its corners as local ids
  ScratchList<VertexId> border_vertices_;  // by local id, as entries of local_id_
  IdVector<VertexId, std::uint8_t> local_id_;  // number of a border vertex, no_local_id elsewhere
  std::vector<FacetId> edge_table_;  // facet of a new cell by (local id, local id) of its edge
};

}  // namespace cocoon
