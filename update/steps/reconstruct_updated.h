// Fourth step of an update: the updated points and their surface.
#pragma once

#include "geom/execution.h"
#include "update/steps/update_run.h"
#include "update/update_model.h"

namespace cocoon {

// Has vertices go and samples come, reconstructs, and asks what may be wrong with the result. Its
// status is ok in the end, or there is no surface, or it was refuted. Errors and complexity: those
// of replace_points() and of parts.reconstruct. Source: Woo & Dey 2005, section 3.5.
void reconstruct_updated(UpdateRun& run, const UpdateParts& parts, const Execution& execution);

}  // namespace cocoon
