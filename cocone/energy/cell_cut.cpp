#include "cocone/energy/cell_cut.h"

#include "cocone/energy/max_flow.h"
#include "geom/arrays/zeroed_array.h"

namespace cocoon {

std::vector<std::uint8_t> cut_cells(const Triangulation& triangulation, BallCosines& cosines,
                                    CellEnergy& energy, const IdVector<CellId, CellLabel>& labels,
                                    const std::vector<CellId>& cells) {
  ZeroedArray<CellId, std::uint32_t> place(triangulation.num_cells());  // 1 + that in `cells`
  for (std::uint32_t k = 0; k < cells.size(); ++k) place[cells[k]] = k + 1;
  MaxFlow flow(cells.size());
  for (std::uint32_t node = 0; node < cells.size(); ++node) {
    const CellId c = cells[node];
    const Energy cost_of_out = energy.preference(c);
    if (cost_of_out < 0) flow.pull_to_source(node, -cost_of_out);
    if (cost_of_out > 0) flow.pull_to_sink(node, cost_of_out);
    for (int i = 0; i < 4; ++i) {
      const FacetId f = facet_id(c, i);
      const CellId behind = cosines.beyond(f);
      if (behind.is_none() || behind == c) continue;
      const bool adjacent = behind == triangulation.neighbor(c, i);
      if (adjacent && place[behind] != 0 && behind < c) continue;  // asked from there
      const Energy cost = energy.facet_cost(f);
      if (place[behind] == 0 && labels[behind] == CellLabel::out) {
        flow.pull_to_source(node, cost);
      } else if (place[behind] == 0) {
        flow.pull_to_sink(node, cost);
      } else {
        // What meets through flat cells is seen from both sides, mostly.
        flow.add_edge(node, place[behind] - 1, adjacent ? cost : cost / 2);
      }
    }
  }
  return flow.source_side();
}

}  // namespace cocoon
