// What a changing triangulation knows of its candidates, for the stages after them.
#pragma once

#include "cocone/live/live_candidates.h"
#include "cocone/live/reconstruct_stages.h"

namespace cocoon {

// Without `left`. Precondition: candidates.exists(), and no slot is free
// (DynamicDelaunay::close_gaps). Complexity: O(n).
KnownCandidates known_candidates(const LiveCandidates& candidates);
// Those that were not pruned. Precondition and complexity: the same.
FacetSet candidates_left(const LiveCandidates& candidates);

}  // namespace cocoon
