// Bowyer-Watson insertion of one point: find the cells whose circumsphere contains it, remove
// them, and fill the hole with the cells that join its border to the point.
// Source: Bowyer 1981 and Watson 1981.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "delaunay/delaunay.h"
#include "delaunay/kernel/cell_pool.h"
#include "delaunay/kernel/conflict_search.h"
#include "delaunay/kernel/vertex_claims.h"
#include "geom/id_vector.h"
#include "geom/point.h"

namespace cocoon {

// What an inserter needs to work on the same cells as others, each on a thread of its own.
struct SharedInsertion {
  ClaimHolder* holder;        // takes every vertex that must be held
  std::vector<CellId>* free;  // slots of this thread alone, used instead of the pool's
  CellId* cell_at;            // by vertex a cell there; kept up to date, accessed only where held
};

// Inserts points one after the other; holds the scratch memory that insertions share.
class CavityInserter {
 public:
  // `points` must outlive the inserter; ids of inserted vertices index it.
  CavityInserter(CellPool& pool, const IdVector<VertexId, Point>& points,
                 const Execution& execution = {});

  // A cell to start the insertion of p from, found by walking from `hint`; one with a corner there
  // if p is a vertex already (ConflictSearch::find_start).
  CellId find_start(const Point& p, CellId hint, DelaunayCounters& counters) {
    return search_.find_start(p, hint, counters);
  }

  // Inserts vertex v, whose point lies in conflict with cell `start` (the result of find_start).
  // Precondition: the point is not equal to a vertex of the triangulation.
  // Returns a cell at v. Errors: InputError if the cells exceed their 30-bit numbering.
  // Complexity: O(size of the conflict zone).
  CellId insert(VertexId v, CellId start, DelaunayCounters& counters);

  // --- The same in steps, for several threads (delaunay/kernel/vertex_claims.h) ---

  // An inserter beside `other`, which is not used meanwhile: same pool and points.
  CavityInserter(const CavityInserter& other, const SharedInsertion& shared);

  // First step of insert, where `start` is the result of find_start. False if another thread is in
  // the way: then no cell was changed.
  bool find_zone(VertexId v, CellId start, DelaunayCounters& counters) {
    return search_.find_zone(points_[v], start, counters);
  }
  // Second step, or none. Precondition of filling: so many slots are free.
  std::size_t num_slots_wanted() const;
  CellId fill_zone(VertexId v, DelaunayCounters& counters);
  void abandon_zone() { search_.unmark_zone(); }

  // Of the last insertion: the new cells, and the cells that are gone. Most new ones are in the
  // place of one that is gone.
  std::span<const CellId> new_cells() const { return slots_; }
  std::span<const CellId> removed_cells() const { return search_.zone().cells(); }

  // To be called for each point with which `points` was extended. Amortized O(1).
  void admit(const Point& p);

  // To be called after `points` was filled with other points. Complexity: O(n).
  void read_points_again();

 private:
  template <unsigned stride, bool notes_cells>
  void build_star(VertexId v, const ConflictZone& zone);
  void build_large_star(VertexId v, std::span<const FacetId> border);
  void fill_hole(VertexId v, const ConflictZone& zone);
  void note_cells_at_corners();
  void put_infinite_last(CellId c);

  CellPool& pool_;
  const IdVector<VertexId, Point>& points_;
  SharedInsertion shared_;  // of an inserter that works alone only the slots, the pool's
  ConflictSearch search_;
  std::vector<CellId> slots_;  // the new cells, one for each facet of the border
  // For each border facet its edges in edge_table_, as the neighbors of the new cell enter them.
  std::vector<std::array<std::uint16_t, 3>> reverse_edges_;
  // Number of a vertex of the zone; anything elsewhere. Memory is taken where it is written to.
  std::vector<std::uint8_t, OverwriteAllocator<std::uint8_t>> local_id_;
  std::vector<FacetId> edge_table_;  // facet of a new cell by (local id, local id) of its edge
  // Of large borders: a facet of a new cell by its edge, the smaller vertex in the upper half.
  static constexpr std::uint64_t no_edge = ~std::uint64_t{0};
  struct WaitingFacet {
    std::uint64_t edge = no_edge;
    FacetId facet;
  };
  std::vector<WaitingFacet> waiting_;
};

}  // namespace cocoon
