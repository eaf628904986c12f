// Second step of an update: where the rims lie on the model.
#pragma once

#include "geom/execution.h"
#include "update/steps/update_run.h"

namespace cocoon {

// Locates the rims, taking those of other trials where they lie better, and traces the border from
// facet to facet. False if some cloud has no rim after all, or one that is not on the
// model; all are looked at.
// Precondition: run.index is set. Errors and complexity: those of locate_rims() and trace_border().
// Source: Woo & Dey 2005, section 3.3.
bool find_overlap(UpdateRun& run, const Execution& execution);

// The border of the loops that are on the model by now.
void trace_borders(UpdateRun& run, const Execution& execution);

}  // namespace cocoon
