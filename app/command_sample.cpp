#include <filesystem>
#include <fmt/format.h>

#include "app/commands.h"
#include "app/files/files.h"
#include "geom/messages/counted.h"
#include "io/atomic_file.h"
#include "io/mesh_file.h"
#include "io/point_file.h"
#include "io/sample_models.h"

namespace cocoon::app {

void run(const SampleArguments& arguments, Job& job) {
  const std::string folder = arguments.folder.empty() ? arguments.name : arguments.folder;
  job.make_folder(folder);
  const auto cloud_file = [&](std::size_t c) {
    return in_folder(folder, fmt::format("cloud-{}.xyz", c + 1));
  };
  std::vector<OutputFile> outputs = {{in_folder(folder, "initial.xyz")},
                                     {in_folder(folder, "truth.ply")},
                                     {in_folder(folder, "replaced.txt")}};
  for (std::size_t c = 0; c < sample_cloud_count(arguments.name); ++c) {
    outputs.push_back({cloud_file(c)});
  }
  require_outputs(job, outputs);
  SampleOptions options;
  options.points = arguments.points;
  options.cloud_points = arguments.cloud_points;
  if (arguments.seed) options.seed = *arguments.seed;
  const SampleModel model = timed(job.execution(), "sample", [&] {
    return sample_model(arguments.name, options, job.execution());
  });

  timed(job.execution(), "write", [&] {
    write_points(in_folder(folder, "initial.xyz"), model.initial, {}, job.outputs());
    for (std::size_t c = 0; c < model.clouds.size(); ++c) {
      write_points(cloud_file(c), model.clouds[c], {}, job.outputs());
    }
    write_mesh(in_folder(folder, "truth.ply"), model.truth, {}, job.outputs());
    std::string replaced;
    for (const PointId point : model.replaced) replaced += fmt::format("{}\n", point.value);
    write_file(in_folder(folder, "replaced.txt"), replaced, job.outputs());
  });

  for (std::size_t c = model.clouds.size(); std::filesystem::exists(cloud_file(c)); ++c) {
    job.warn(cloud_file(c) + ": is left from another model, and no cloud of this one; remove it");
  }
  std::vector<std::size_t> cloud_sizes;
  for (const auto& cloud : model.clouds) cloud_sizes.push_back(cloud.size());
  job.report().set("sample/name", arguments.name);
  job.report().set("sample/seed", static_cast<std::size_t>(options.seed));
  job.report().set("sample/points", model.initial.size());
  job.report().set("sample/clouds", cloud_sizes);
  job.report().set("sample/replaced_points", model.replaced.size());
  job.report().set("sample/truth_triangles", model.truth.triangles.size());
  job.say_outputs("{}: {} initial points -> {}", arguments.name, model.initial.size(),
                  in_folder(folder, "initial.xyz"));
  for (std::size_t c = 0; c < model.clouds.size(); ++c) {
    job.say_outputs("cloud {}: {} points -> {}", c + 1, model.clouds[c].size(), cloud_file(c));
  }
  job.say_outputs("true updated surface: {} triangles -> {}", model.truth.triangles.size(),
                  in_folder(folder, "truth.ply"));
  job.say_outputs("{} made wrong by the change -> {}",
                  counted(model.replaced.size(), "initial point is", "initial points are"),
                  in_folder(folder, "replaced.txt"));
  job.finish();
}

}  // namespace cocoon::app
