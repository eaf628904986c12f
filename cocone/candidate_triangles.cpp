#include "cocone/candidate_triangles.h"

#include "cocone/inputs/stage_inputs.h"

namespace cocoon {

FacetSet candidate_triangles(const Triangulation& triangulation, const Cocones& cocones,
                             const VertexSet& boundary, const Execution& execution) {
  return list_candidate_triangles(triangulation, cocones, boundary, execution).set;
}

CandidateTriangles list_candidate_triangles(const Triangulation& triangulation,
                                            const Cocones& cocones, const VertexSet& boundary,
                                            const Execution& execution) {
  require_cocones("candidate_triangles", triangulation, cocones);
  require_vertex_flags("candidate_triangles", triangulation, boundary);
  report_progress(execution, "candidate_triangles", 0);
  CandidateTriangles candidates{FacetSet(triangulation.num_cells()), {}, {}};
  candidates.facets.reserve(cocones.facets.size());
  candidates.corners.reserve(cocones.facets.size());
  for (std::size_t k = 0; k < cocones.facets.size(); ++k) {
    const auto& [a, b, c] = cocones.corners[k];
    const unsigned boundary_bits =
        unsigned{boundary[a]} | unsigned{boundary[b]} << 1 | unsigned{boundary[c]} << 2;
    const unsigned voters = 7U & ~boundary_bits;  // bit i: corner i votes
    if (voters == 0 || (voters & ~cocones.met_corners(k)) != 0) continue;
    candidates.set.insert(cocones.facets[k], cocones.mirrors[k]);
    candidates.facets.push_back(cocones.facets[k]);
    candidates.corners.push_back(cocones.corners[k]);
  }
  report_progress(execution, "candidate_triangles", 1);
  return candidates;
}

}  // namespace cocoon
