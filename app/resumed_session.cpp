#include "app/resumed_session.h"

#include <fmt/format.h>
#include <utility>

#include "app/arguments/update_options.h"
#include "app/files/pending_clouds.h"
#include "geom/errors.h"

namespace cocoon::app {

namespace {

// Those that may differ from update to update.
struct OptionsOfClouds {
  std::optional<double> rho;
  bool keep_crowded = false;

  friend bool operator==(const OptionsOfClouds&, const OptionsOfClouds&) = default;
};

// Of a command, or of an update that waits.
template <class Options>
OptionsOfClouds options_of(const Options& options) {
  return {options.rho, options.keep_crowded};
}

}  // namespace

void resume_session(const std::string& path, SavedSession saved, const SurfaceArguments& parameters,
                    const Execution& execution, ResumedSession& resumed) {
  resumed.parameters = saved.parameters;
  SurfaceArguments arguments = saved.parameters;
  arguments.verify = parameters.verify;
  const auto take_up = [&](SessionSnapshot snapshot, const OptionsOfClouds& options) {
    arguments.rho = options.rho;
    arguments.keep_crowded = options.keep_crowded;
    resumed.session.emplace(std::move(snapshot), update_options(arguments), SnapshotCheck::done,
                            execution);
    resumed.session->limit_undo(0);  // no command goes back
  };
  const auto go_on_with = [&](const OptionsOfClouds& options) {
    if (options == options_of(arguments)) return;
    take_up(resumed.session->snapshot(), options);
  };
  const std::vector<PendingUpdate> updates = load_pending_clouds(path, saved.notes);
  resumed.notes = std::move(saved.notes);
  resumed.pending = 0;
  take_up(std::move(saved.snapshot),
          updates.empty() ? options_of(parameters) : options_of(updates.front()));
  for (const PendingUpdate& update : updates) {
    if (!update.refused) {
      go_on_with(options_of(update));
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
  go_on_with(options_of(parameters));
}

}  // namespace cocoon::app
