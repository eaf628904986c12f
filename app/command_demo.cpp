#include "app/commands.h"
#include "app/files.h"
#include "app/updating.h"
#include "io/mesh_file.h"
#include "io/point_file.h"
#include "io/sample_models.h"

namespace cocoon::app {

void run_demo(const DemoArguments& arguments, Job& job) {
  require_outputs(job, {});
  const UpdateOptions options = update_options({});
  const SampleModel block = timed(job.execution(), "sample", [] { return sample_model("block"); });
  UpdateInput input;
  input.model_name = "test block";
  input.model = initial_model(job, input.model_name, block.initial, {}, options.reconstruct).mesh;
  input.clouds = block.clouds;
  input.cloud_names.assign(block.clouds.size(), "U-shaped cloud");

  make_folder(arguments.folder);
  write_mesh(in_folder(arguments.folder, "initial.ply"), input.model, {}, job.outputs());
  write_points(in_folder(arguments.folder, "cloud.ply"), input.clouds.front(), {}, job.outputs());
  update_and_write(job, input, options,
                   {in_folder(arguments.folder, "updated.ply"), "",
                    in_folder(arguments.folder, "report.html"), false});
  job.finish(in_folder(arguments.folder, "report.json"));
}

}  // namespace cocoon::app
