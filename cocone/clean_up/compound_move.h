// A change of a labeling in several moves, the first of which may raise the energy
// (clean_up_cells.h, step 5).
#pragma once

#include <cstddef>
#include <vector>

#include "cocone/clean_up/best_move.h"
#include "cocone/energy/cell_energy.h"
#include "cocone/energy/doubtful_region.h"
#include "cocone/samples/sample_spacing.h"
#include "delaunay/triangulation.h"

namespace cocoon {

class CompoundMove {
 public:
  // All references must outlive the object. O(1).
  CompoundMove(const Triangulation& triangulation, SpacingCache& spacings,
               const DoubtfulRegion& region, CellEnergy& energy, BestMove& best_move,
               const CleanUpOptions& options);

  // Sets of finite cells that change sides one after the other, such that the energy falls in all;
  // empty if there are none. The first max_openings openings (BestMove::openings) at v are tried:
  // best moves follow at its vertices that cost something, then at theirs, while they lower the
  // energy, but at none that is left alone (DoubtfulRegion::is_left). Of these trials the best,
  // ties by the rank of the opening. The labeling is as before. Complexity: for each opening a best
  // move (BestMove::find) at each vertex that it and the moves after it touch, if that costs
  // something. Source: ours, after Kernighan & Lin 1970 (a gain may need a loss before it).
  std::vector<std::vector<CellId>> find(VertexId v);

 private:
  Energy follow(std::vector<std::vector<CellId>>& moves);

  const Triangulation& triangulation_;
  SpacingCache& spacings_;
  const DoubtfulRegion& region_;
  CellEnergy& energy_;
  BestMove& best_move_;
  Energy max_rise_;
  std::size_t max_openings_;
};

}  // namespace cocoon
