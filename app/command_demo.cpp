#include "app/arguments/update_options.h"
#include "app/commands.h"
#include "app/files/files.h"
#include "app/initial_model.h"
#include "app/updating.h"
#include "io/mesh_file.h"
#include "io/point_file.h"
#include "io/sample_models.h"

namespace cocoon::app {

void run(const DemoArguments& arguments, Job& job) {
  const auto output = [&](const char* name) { return in_folder(arguments.folder, name); };
  const bool is_asked_for = place_of(job.shared().json) == place_of(output("report.json"));
  job.make_folder(arguments.folder);
  require_outputs(job, {{output("initial.ply")},
                        {output("cloud.ply")},
                        {output("updated.ply")},
                        {output("report.html")},
                        {is_asked_for ? "" : output("report.json")}});
  const UpdateOptions options = update_options({});
  const SampleModel block =
      timed(job.execution(), "sample", [&] { return sample_model("block", {}, job.execution()); });
  UpdateInput input;
  input.model_name = "test block";
  input.model = initial_model(job, input.model_name, block.initial, {}, options.reconstruct).mesh;
  input.clouds = block.clouds;
  input.cloud_names.assign(block.clouds.size(), "U-shaped cloud");

  write_mesh(output("initial.ply"), input.model, {}, job.outputs());
  write_points(output("cloud.ply"), input.clouds.front(), {}, job.outputs());
  write_update(job, input, updated(job, input, options), options,
               {output("updated.ply"), "", output("report.html"), {}});
  job.finish(is_asked_for ? "" : output("report.json"));
}

}  // namespace cocoon::app
