#include <fmt/format.h>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "app/arguments/update_options.h"
#include "app/coarse_model.h"
#include "app/commands.h"
#include "app/console/interrupt.h"
#include "app/files/carried_properties.h"
#include "app/files/files.h"
#include "app/files/pending_clouds.h"
#include "app/files/session_file.h"
#include "app/resumed_session.h"
#include "app/shapes/cloud_filter.h"
#include "app/updating.h"
#include "geom/errors.h"
#include "geom/search/equal_points.h"
#include "io/lock_file.h"

namespace cocoon::app {

namespace {

void refuse_model_as_cloud(const UpdateInput& input) {
  for (std::size_t c = 0; c < input.clouds.size(); ++c) {
    if (!is_model_itself(input.clouds[c], input.model)) continue;
    throw InputError(fmt::format(
        "cannot update {0}: {1} is no cloud but the model itself, all of its vertices; give "
        "only scans of what changed (a session has its model already)",
        input.model_name, input.cloud_names[c]));
  }
}

void filter_input(Job& job, const CloudFilter& filter, UpdateInput& input) {
  std::span<VertexProperties> properties = input.properties;
  if (!properties.empty()) properties = properties.subspan(1);  // behind those of the model
  input.strays = filter_clouds(job, filter, input.cloud_names, input.clouds, properties);
}

UpdateOutput output_of(const UpdateArguments& arguments) {
  return {arguments.mesh, arguments.map, arguments.html, arguments.writing, arguments.manifold};
}

// Reads the session, updates it, and writes it back together with the mesh.
void update_session(const UpdateArguments& arguments, const CloudFilter& filter, Job& job) {
  const LockFile lock(arguments.session);
  StopWhenInterrupted stop;
  const Execution quiet{job.execution().threads, &stop};
  ResumedSession resumed;
  timed(job.execution(), "read", [&] {
    resume_session(arguments.session, load_session(arguments.session, quiet), arguments.parameters,
                   quiet, resumed);
  });
  UpdateSession& session = *resumed.session;
  UpdateInput input;
  input.model_name = arguments.session;
  input.model = session.model();
  for (const std::string& cloud : arguments.clouds) {
    input.cloud_names.push_back(cloud);
    input.clouds.push_back(read_cloud(job, cloud, "input"));
  }
  refuse_model_as_cloud(input);
  filter_input(job, filter, input);
  UpdateOptions options = session.options();
  options.overrides = region_overrides(arguments);
  UpdateOutcome outcome = updated(job, input, options, &session);
  UpdateOutput output = output_of(arguments);
  output.keeps_session = true;
  write_update(job, input, std::move(outcome), options, output);
  timed(job.execution(), "write", [&] {
    save_session(arguments.session,
                 {std::move(session).release(), resumed.parameters, resumed.notes}, job.outputs());
  });
  job.finish();
  remove_pending_clouds(arguments.session);
}

}  // namespace

void run(const UpdateArguments& arguments, Job& job) {
  std::vector<std::string> inputs = arguments.clouds;
  if (!arguments.model.empty()) inputs.push_back(arguments.model);
  require_outputs(job,
                  {{arguments.mesh, mesh_extensions, arguments.model},
                   {arguments.map},
                   {arguments.html},
                   {.path = arguments.session, .is_session = true}},
                  inputs);
  const CloudFilter filter = cloud_filter(arguments.filter);
  if (!arguments.session.empty()) {
    update_session(arguments, filter, job);
    return;
  }
  UpdateOptions options = update_options(arguments.parameters);
  options.overrides = region_overrides(arguments);
  UpdateInput input = read_update_input(job, arguments, options);
  refuse_model_as_cloud(input);
  filter_input(job, filter, input);
  job.report().set("parameters/keep_coarse", keeps_coarse(arguments));
  UpdateOutcome outcome = keeps_coarse(arguments) ? updated(job, input, options)
                                                  : updated_dense_enough(job, input, options);
  write_update(job, input, std::move(outcome), options, output_of(arguments));
  job.finish();
}

}  // namespace cocoon::app
