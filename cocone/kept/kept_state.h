// What is kept of the stages, in the numbers of a triangulation without gaps: for sessions that are
// saved, and points that are taken over.
#pragma once

#include "cocone/kept/certified_surface.h"
#include "cocone/kept/kept_stages.h"
#include "cocone/live/live_candidates.h"
#include "cocone/live/surface_state.h"
#include "delaunay/compact_delaunay.h"

namespace cocoon {

// What the stages found, in the numbers of `whole`, as far as it exists: up to pruning, and from
// there on the certified surface, or marks and body that are kept. Complexity: O(slots).
SurfaceState kept_state(const LiveCandidates& candidates, const CertifiedSurface& certified,
                        const KeptStages& kept, const CompactDelaunay& whole);

}  // namespace cocoon
