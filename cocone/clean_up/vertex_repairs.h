// Moves at flawed vertices, one after the other (clean_up_cells.h, steps 2 and 5).
#pragma once

#include <cstddef>

#include "cocone/clean_up/best_move.h"
#include "cocone/clean_up/changing_labels.h"
#include "cocone/clean_up/compound_move.h"
#include "cocone/clean_up_cells.h"
#include "geom/execution.h"
#include "geom/ids.h"

namespace cocoon {

class VertexRepairs {
 public:
  // `labels` and `options` must outlive the object. O(1).
  VertexRepairs(ChangingLabels& labels, const CleanUpOptions& options, const Execution& execution);

  // The best move at every sample that is unused or where the surface is pinched (both ends of a
  // non-manifold edge are), in the order of the region, round by round until no move helps. Counts.
  // Progress: "clean_up_cells", a half. Complexity: that of BestMove::find() for each vertex that
  // is flawed or touched; it ends, since each move lowers the energy, which is an integer.
  void move(CleanUpCounters& counters);
  // At what single moves did not mend, once each. Returns whether something has changed. Counts.
  bool make_compound_moves(CleanUpCounters& counters);
  // BestMove::is_too_large().
  bool is_too_large(VertexId v) { return best_move_.is_too_large(v); }

 private:
  void tell_turn();

  ChangingLabels& labels_;
  Execution execution_;
  bool makes_compound_moves_;
  BestMove best_move_;
  CompoundMove compound_move_;
  std::size_t turns_ = 0;
};

}  // namespace cocoon
