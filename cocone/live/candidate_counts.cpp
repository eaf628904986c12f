#include "cocone/live/candidate_counts.h"

namespace cocoon {

void CandidateCounts::report(ReconstructCounters& counters) const {
  counters.hull_vertices = hull_vertices;
  counters.degenerate_poles = degenerate;
  counters.exact_centers = exact_centers;
  counters.dual_facet_fallbacks = facet_centers;
  counters.boundary_samples = boundary;
  counters.ratio_failed = ratio_failed;
  counters.recovered_samples = recovered;
  counters.candidates = candidates / 2;
  counters.pruned = pruned / 2;
  counters.umbrellas = umbrellas;
}

}  // namespace cocoon
