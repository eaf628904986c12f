#include "app/commands.h"
#include "app/files.h"
#include "app/updating.h"

namespace cocoon::app {

void run_update(const UpdateArguments& arguments, Job& job) {
  require_outputs(job,
                  {{arguments.mesh, mesh_extensions}, {arguments.map, {}}, {arguments.html, {}}});
  const UpdateOptions options = update_options(arguments.parameters);
  UpdateInput input;
  input.model_name = arguments.model;
  input.model = read_shape(job, arguments.model, "input");
  for (const std::string& cloud : arguments.clouds) {
    input.cloud_names.push_back(cloud);
    input.clouds.push_back(read_cloud(job, cloud, "input"));
  }
  if (input.model.triangles.empty()) {
    input.model =
        initial_model(job, arguments.model, input.model.points.raw(), options.reconstruct);
  }
  update_and_write(job, input, options,
                   {arguments.mesh, arguments.map, arguments.html, arguments.ascii});
  job.finish();
}

}  // namespace cocoon::app
