#include "app/resumed_session.h"

#include <fmt/format.h>
#include <utility>

#include "app/arguments/update_options.h"
#include "app/files/pending_clouds.h"
#include "geom/errors.h"

namespace cocoon::app {

void resume_session(const std::string& path, SavedSession saved, const SurfaceArguments& parameters,
                    const Execution& execution, ResumedSession& resumed) {
  resumed.parameters = saved.parameters;
  SurfaceArguments arguments = saved.parameters;
  arguments.verify = parameters.verify;
  const auto take_up = [&](SessionSnapshot snapshot, std::optional<double> rho, bool keep_crowded) {
    arguments.rho = rho;
    arguments.keep_crowded = keep_crowded;
    resumed.session.emplace(std::move(snapshot), update_options(arguments), SnapshotCheck::done,
                            execution);
    resumed.session->limit_undo(0);  // no command goes back
  };
  const auto go_on_with = [&](std::optional<double> rho, bool keep_crowded) {
    if (rho == arguments.rho && keep_crowded == arguments.keep_crowded) return;
    take_up(resumed.session->snapshot(), rho, keep_crowded);
  };
  const std::vector<PendingUpdate> updates = load_pending_clouds(path, saved.notes);
  resumed.notes = std::move(saved.notes);
  resumed.pending = 0;
  if (updates.empty()) {
    take_up(std::move(saved.snapshot), parameters.rho, parameters.keep_crowded);
  } else {
    take_up(std::move(saved.snapshot), updates.front().rho, updates.front().keep_crowded);
  }
  for (const PendingUpdate& update : updates) {
    if (!update.refused) {
      go_on_with(update.rho, update.keep_crowded);
      const UpdateResult result = resumed.session->apply(update.clouds, execution).result;
      if (result.status != UpdateStatus::ok) {
        throw InputError(
            fmt::format("{}: a cloud that was applied before is refused now ({}): {}; "
                        "begin again from the model",
                        pending_cloud_file(path, resumed.notes.size()), name_of(result.status),
                        result.message));
      }
    }
    resumed.notes.insert(resumed.notes.end(), update.notes.begin(), update.notes.end());
    resumed.pending += update.notes.size();
  }
  go_on_with(parameters.rho, parameters.keep_crowded);
}

}  // namespace cocoon::app
