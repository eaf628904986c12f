// First step of an update: the surface of each cloud, and its rim.
#pragma once

#include <cstddef>

#include "geom/execution.h"
#include "update/steps/update_run.h"

namespace cocoon {

// Looks for the surfaces of each cloud, best first. False if some cloud has none, or none with a
// loop; all are looked at.
// Errors and complexity: those of joined_cloud_surfaces(), with the name of the cloud. Source: Woo
// & Dey 2005, section 3.2.
bool detect_boundaries(UpdateRun& run, const Execution& execution);

// UpdateRun::fail(), since cloud c gives no surface, or one without a rim.
bool fail_without_rim(UpdateRun& run, std::size_t c);

}  // namespace cocoon
