// Third step of an update, second half: which regions are replaced.
#pragma once

#include <span>

#include "geom/execution.h"
#include "update/rim_angles.h"
#include "update/steps/update_run.h"

namespace cocoon {

// Chooses by the angle condition, by samples where the model turns away from a cloud on both sides
// of its rim, or else by angles that differ much; then by islands that samples contradict, and by
// what the user says. `angles`: of each border loop, by segment_under_clouds(). False if the choice
// is ambiguous. Errors and complexity: those of choose_regions(), regions_under_samples() and
// part_contradicted_islands(). Source: Woo & Dey 2005, section 3.4; what decides besides angles is
// ours (docs/departures.md, departures 33 and 27).
bool choose_replaced(UpdateRun& run, std::span<const RegionAngles> angles,
                     const Execution& execution);

}  // namespace cocoon
