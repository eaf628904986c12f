// Updates of models whose triangles may be too large for their scans (dense_trial.h): carried out,
// and told.
#pragma once

#include <string>

#include "app/job.h"
#include "app/update_input.h"
#include "app/updating.h"
#include "update/checks/dense_trial.h"
#include "update/update_model.h"

namespace cocoon::app {

// Whether an update takes its model as it is: if it was told to, and in paper mode, as published.
template <class Arguments>
bool keeps_coarse(const Arguments& arguments) {
  return arguments.keep_coarse || arguments.parameters.mode == Mode::paper;
}

// Updates the model, and if it is the mesh of a file that loses surface, or cannot be updated,
// since its triangles are too large for the scans, makes it dense (with_dense_model) and updates it
// again. If that keeps more of the surface where nothing was scanned, it becomes the `input`, and a
// warning says so; else the first outcome is returned, and nothing is told of the other but why.
// Section "update/coarse_model" of the report. What is said of regions holds for the model that is
// chosen without. Stages come again. Throws InputError as `updated`.
UpdateOutcome updated_dense_enough(Job& job, UpdateInput& input, const UpdateOptions& options,
                                   const DenseTrialOptions& trial = {});

// For an update that is yet to come, of a session or with regions that are said to go or stay:
// makes the model dense if updated_dense_enough would, and tells the user the same; not if few of
// its triangles are large (min_large_share), which is known without an update. Returns what became
// of a trial that was not taken (UpdateOutcome::tried). Throws as `updated`.
std::string make_dense_enough(Job& job, UpdateInput& input, const UpdateOptions& options,
                              const DenseTrialOptions& trial = {});

}  // namespace cocoon::app
