// The best local change of a labeling at one vertex (clean_up_cells.h, step 2).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "cocone/clean_up/far_reach.h"
#include "cocone/clean_up/label_split.h"
#include "cocone/energy/cell_energy.h"
#include "delaunay/star_cache.h"
#include "delaunay/triangulation.h"

namespace cocoon {

// Would the cells, on their other side, hang together with cells that are there already? Else their
// flip would found a new part of the body, or a cavity. `out`: the side of each cell, 0 or 1.
// Complexity: O(k^2) for k cells, O(k) where the answer is yes.
bool is_attached(const Triangulation& triangulation, const IdVector<CellId, std::uint8_t>& out,
                 std::span<const CellId> cells);

class BestMove {
 public:
  // All references must outlive the object. O(1).
  BestMove(const Triangulation& triangulation, StarCache& stars,
           const IdVector<CellId, std::uint8_t>& out, CellEnergy& energy, LabelSplit& label_split,
           FarReach& far_reach, std::size_t most_cells);

  // Has v more than most_cells cells? Then there are neither moves nor openings at it. O(1) if the
  // star is known.
  bool is_too_large(VertexId v) { return stars_.star(v).size() > most_cells_; }

  // The finite cells that should change sides: of the single cells at v, the pairs of neighbors
  // with one of them at v, and the parts into which the surface divides the star, those whose flip
  // lowers the energy most; ties by cell_order.h. Such that are not attached, or whose flip would
  // divide the rest of their side, are not considered; nor, if v is unused but near the surface,
  // single cells and pairs that reach far. Empty if nothing lowers the energy.
  // Those that promise most (CellEnergy::least_change) are evaluated first, and what cannot be
  // better than the best so far is not evaluated. Complexity: O(star) bounds, and O(star) for each
  // evaluation. Source: ours, docs/stages/clean_up_cells.md.
  std::vector<CellId> find(VertexId v);

  // A set that may change sides, and by how much the energy grows then.
  struct Opening {
    Energy change;
    std::vector<CellId> cells;
  };
  // Of the same sets those whose flip lowers the cost of v and raises the energy by at most
  // `max_rise`, the `most` with the least change; by their change, ties by cell_order.h. Evaluated
  // are only those that promise most, asked_per_opening for each that is wanted, since a star may
  // have as many sets as there are samples. Complexity: O(star log star) bounds, and O(stars) for
  // each evaluation.
  static constexpr std::size_t asked_per_opening = 10;
  std::vector<Opening> openings(VertexId v, Energy max_rise, std::size_t most);

 private:
  struct Candidate {
    Energy least;  // its change is no less
    std::array<CellId, 2> cells;
    std::size_t size;
  };
  void list_candidates(VertexId v, Energy limit);
  std::vector<std::vector<CellId>> large_parts(VertexId v);
  void consider(std::span<const CellId> cells);
  void keep_least(std::vector<Opening>& sets, std::size_t most) const;

  const Triangulation& triangulation_;
  StarCache& stars_;
  const IdVector<CellId, std::uint8_t>& out_;
  CellEnergy& energy_;
  LabelSplit& label_split_;
  FarReach& far_reach_;
  std::size_t most_cells_;
  std::vector<Candidate> candidates_;
  Energy best_change_ = 0;
  std::vector<CellId> best_;
};

}  // namespace cocoon
