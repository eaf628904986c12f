// From the parameters of the command line (degrees) to the options of the Cocone stages.
#pragma once

#include <string>

#include "app/command_line.h"
#include "app/json_report.h"
#include "cocone/reconstruct.h"

namespace cocoon::app {

// `defaults` with what the user has set.
ReconstructOptions surface_options(const SurfaceArguments& arguments, ReconstructOptions defaults);

// As the options --mode and --radius have them.
const char* name_of(Mode mode);
const char* name_of(RadiusMode mode);

// The section "parameters" of the report: what was used, given or not. `part`: a section in it
// ("model"); empty: itself.
void add_parameters(JsonReport& report, const ReconstructOptions& options,
                    const std::string& part = "");

// An angle as people give it: in degrees, without what the way there and back adds in the last
// digits. O(1).
double told_in_degrees(double radians);

}  // namespace cocoon::app
