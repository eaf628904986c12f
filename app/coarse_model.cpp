#include "app/coarse_model.h"

#include <cstdlib>
#include <fmt/format.h>
#include <string>
#include <utility>

#include "geom/errors.h"
#include "update/report/cloud_report.h"

namespace cocoon::app {

namespace {

// In two digits, as it is told: --densify with this number gives the same.
double spacing_to_try(const UpdateInput& input, const DenseTrialOptions& trial) {
  const double spacing = dense_spacing(input.model, input.clouds, trial);
  return std::strtod(fmt::format("{:.2g}", spacing).c_str(), nullptr);
}

bool is_worth_trial(const UpdateInput& input, const UpdateOutcome& outcome,
                    const DenseTrialOptions& trial) {
  return is_worth_dense_trial(input.model, input.clouds, outcome.update.result, outcome.lost,
                              trial);
}

// The same made dense and updated.
struct DenseUpdate {
  UpdateInput input;
  UpdateOutcome outcome;
};

// What the first would have lost and made up, or why it is no use, for the report and the user.
void tell(Job& job, const UpdateInput& input, const UpdateResult& first, const KeptAreas& areas,
          double spacing) {
  std::string what = fmt::format("it cannot be updated so ({})", name_of(first.status));
  if (first.status == UpdateStatus::ok) {
    const double lost = areas.only_dense / areas.all;
    const double made_up = areas.made_up_by_first / areas.all;
    job.report().set("update/coarse_model/lost_area_share", lost);
    job.report().set("update/coarse_model/made_up_area_share", made_up);
    what = fmt::format("of its surface {:.3g} % would be lost and {:.3g} % made up", 100 * lost,
                       100 * made_up);
  }
  job.warn(fmt::format(
      "{} has large triangles, and {}: it was made dense first (as by --densify {}; --keep-coarse "
      "takes its vertices alone)",
      input.model_name, what, spacing));
}

// Why it is not taken; empty: it is, and the job was told so. Fills in what of it can be.
std::string try_dense(Job& job, const UpdateInput& input, const UpdateOutcome& outcome,
                      const UpdateOptions& options, double spacing, const DenseTrialOptions& trial,
                      DenseUpdate& dense) {
  const std::string made_dense = fmt::format("made dense (--densify {}) it ", spacing);
  try {
    dense.input = with_dense_model(job, input, spacing, options.reconstruct);
    dense.outcome = updated(job, dense.input, options);
  } catch (const InputError& error) {
    return made_dense + fmt::format("is of no use ({})", error.what());
  }
  const UpdateResult& result = dense.outcome.update.result;
  if (result.status != UpdateStatus::ok) {
    return made_dense + fmt::format("cannot be updated ({})", name_of(result.status));
  }
  const UpdateResult& first = outcome.update.result;
  const KeptAreas areas = timed(job.execution(), "check", [&] {
    return kept_areas({input.model, first}, {dense.input.model, result},
                      scans_of(input.clouds, result.clouds), trial.lost.astray);
  });
  if (!keeps_more(areas, first.status == UpdateStatus::ok, trial)) {
    return made_dense + "keeps no more";
  }
  tell(job, input, first, areas, spacing);
  return {};
}

// Input and outcome become those of the dense model, if that keeps more of the surface.
void make_dense(Job& job, UpdateInput& input, UpdateOutcome& outcome, const UpdateOptions& options,
                const DenseTrialOptions& trial) {
  const double spacing = spacing_to_try(input, trial);
  if (!(spacing > 0)) return;
  DenseUpdate dense;
  const bool is_taken = job.try_out([&] {
    outcome.tried = try_dense(job, input, outcome, options, spacing, trial, dense);
    return outcome.tried.empty();
  });
  JsonReport& report = job.report();
  report.set("update/coarse_model/status", std::string(name_of(outcome.update.result.status)));
  report.set("update/coarse_model/spacing", spacing);
  report.set("update/coarse_model/made_dense", is_taken);
  if (!is_taken) return;
  input = std::move(dense.input);
  outcome = std::move(dense.outcome);
}

}  // namespace

UpdateOutcome updated_dense_enough(Job& job, UpdateInput& input, const UpdateOptions& options,
                                   const DenseTrialOptions& trial) {
  if (!options.overrides.is_empty()) {
    const std::string tried = make_dense_enough(job, input, options, trial);
    UpdateOutcome said = updated(job, input, options);
    said.tried = tried;
    return said;
  }
  UpdateOutcome outcome = updated(job, input, options);
  if (input.is_mesh_of_file && is_worth_trial(input, outcome, trial)) {
    make_dense(job, input, outcome, options, trial);
  }
  return outcome;
}

std::string make_dense_enough(Job& job, UpdateInput& input, const UpdateOptions& options,
                              const DenseTrialOptions& trial) {
  if (!input.is_mesh_of_file ||
      !has_large_triangles(input.model, input.clouds, trial.min_large_share, trial)) {
    return {};
  }
  UpdateOptions unsaid = options;
  unsaid.overrides = {};
  UpdateOutcome outcome;
  try {
    outcome = updated(job, input, unsaid);
  } catch (const InputError&) {
    return {};  // the update to come has the same to say
  }
  if (is_worth_trial(input, outcome, trial)) make_dense(job, input, outcome, unsaid, trial);
  return outcome.tried;
}

}  // namespace cocoon::app
