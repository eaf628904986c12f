#include "ref/mark_in_rounds.h"

#include <vector>

namespace cocoon::ref {

void mark_in_rounds(const Triangulation& triangulation, const FacetSet& surface,
                    std::span<const VertexId> seeds, CellMarks& marks) {
  for (const CellId c : triangulation.infinite_cells()) marks.labels[c] = CellLabel::out;
  std::vector<CellId> out_cells;
  MarkingRounds(triangulation, surface, marks).run(seeds, out_cells);
}

}  // namespace cocoon::ref
