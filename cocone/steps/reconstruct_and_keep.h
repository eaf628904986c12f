// Reconstruction for those who go on from its stages: what these have found is handed on, and what
// is known of it beforehand taken over.
#pragma once

#include "cocone/known_labels.h"
#include "cocone/live/reconstruct_stages.h"
#include "cocone/reconstruct.h"
#include "delaunay/triangulation.h"
#include "geom/execution.h"
#include "geom/point.h"

namespace cocoon {

// As reconstruct_tight_with_labels of the triangulation, and fills in `stages`.
ReconstructResult reconstruct_and_keep(Triangulation triangulation, Points points,
                                       const KnownLabelsSource& known,
                                       const ReconstructOptions& options,
                                       const Execution& execution, ReconstructStages& stages);

// As reconstruct_tight_with_labels of the triangulation, without these stages; fills in `surface`.
// If live.take_body takes the body the result has neither mesh nor anything by vertex.
ReconstructResult reconstruct_tight_from(const Triangulation& triangulation,
                                         KnownCandidates candidates, Points points,
                                         const KnownLabelsSource& known,
                                         const ReconstructOptions& options,
                                         const Execution& execution, const LiveStages& live,
                                         CoconeSurface& surface);

}  // namespace cocoon
