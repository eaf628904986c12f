// From the parameters of the command line to the options of an update.
#pragma once

#include "app/command_line.h"
#include "app/json_report.h"
#include "update/update_model.h"

namespace cocoon::app {

// The library's options with what the user has set. --rho is that of the clouds' boundaries, and
// then the only one that is tried; the other parameters hold for the updated model and the clouds,
// --alpha for the first trial of each. Mode::paper: paper_update_options().
UpdateOptions update_options(const SurfaceArguments& arguments);

// What the user says of groups of the model.
RegionOverrides region_overrides(const UpdateArguments& arguments);

// In the section "parameters": what clouds and model are reconstructed with.
void add_update_parameters(JsonReport& report, const UpdateOptions& options);

}  // namespace cocoon::app
