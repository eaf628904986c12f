// Third step of an update: the regions of the model, each under a cloud or outside as a whole.
#pragma once

#include <optional>
#include <vector>

#include "geom/execution.h"
#include "update/rim_angles.h"
#include "update/steps/update_run.h"

namespace cocoon {

// Segments the model by the border, and cuts it where rims are partial, run around handles, or end
// on what would go; where the rim or samples tell by that which regions lie under a cloud,
// run.decided says so. Pin-holes beyond which the model does not go on are closed first.
// Returns the angles at each border loop; none if a loop does not cut the model in two, or a cut is
// not to be believed. Errors and complexity: those of segment_model() and cut_regions(). Source:
// Woo & Dey 2005, section 3.4; cuts are ours (docs/departures.md, departure 16).
std::optional<std::vector<RegionAngles>> segment_under_clouds(UpdateRun& run,
                                                              const Execution& execution);

}  // namespace cocoon
