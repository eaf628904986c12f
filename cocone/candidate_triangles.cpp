#include "cocone/candidate_triangles.h"

namespace cocoon {

FacetSet candidate_triangles(const Triangulation& triangulation, const Cocones& cocones,
                             const VertexSet& boundary, const Execution& execution) {
  report_progress(execution, "candidate_triangles", 0);
  FacetSet candidates(triangulation.num_cells());
  for (std::size_t k = 0; k < cocones.facets.size(); ++k) {
    const auto& [a, b, c] = cocones.corners[k];
    const unsigned boundary_bits =
        unsigned{boundary[a]} | unsigned{boundary[b]} << 1 | unsigned{boundary[c]} << 2;
    const unsigned voters = 7U & ~boundary_bits;  // bit i: corner i votes
    if (voters != 0 && (voters & ~cocones.met_corners(k)) == 0) {
      candidates.insert(cocones.facets[k], cocones.mirrors[k]);
    }
  }
  report_progress(execution, "candidate_triangles", 1);
  return candidates;
}

}  // namespace cocoon
