#include "cocone/candidate_triangles.h"

namespace cocoon {

FacetSet candidate_triangles(const Triangulation& triangulation, const Cocones& cocones,
                             const VertexSet& boundary, const Execution& execution) {
  report_progress(execution, "candidate_triangles", 0);
  FacetSet candidates(triangulation.num_cells());
  for (std::size_t k = 0; k < cocones.facets.size(); ++k) {
    const FacetId f = cocones.facets[k];
    const Cell& cell = triangulation.cell(cell_of(f));
    unsigned voters = 0;  // bit j: vertex j votes
    for (const int j : facet_corners[index_of(f)]) {
      const VertexId v = cell.vertices[static_cast<std::size_t>(j)];
      voters |= (boundary[v] == 0 ? 1U : 0U) << j;
    }
    const unsigned row = cocones.rows[k];
    if (voters != 0 && (voters & ~row) == 0) candidates.insert(triangulation, f);
  }
  report_progress(execution, "candidate_triangles", 1);
  return candidates;
}

}  // namespace cocoon
