#include "app/densify.h"

#include <utility>

#include "app/files.h"
#include "geom/counted.h"
#include "geom/dense_samples.h"
#include "geom/errors.h"

namespace cocoon::app {

std::vector<Point> read_densified(Job& job, const std::string& path, double spacing) {
  TriangleMesh mesh = read_shape(job, path, "input");
  if (mesh.triangles.empty()) {
    throw InputError(path + ": --densify needs a mesh, and this file has no triangles");
  }
  const std::vector<Point> added = timed(job.execution(), "dense_samples", [&] {
    return naming_input(path,
                        [&] { return dense_samples(mesh, {.spacing = spacing}, job.execution()); });
  });
  job.report().set("input/vertices", mesh.points.size());
  job.report().set("input/added_samples", added.size());
  job.say("{}: {} added to {}", path, counted(added.size(), "sample"),
          counted(mesh.points.size(), "vertex", "vertices"));
  std::vector<Point> points = std::move(mesh.points).raw();
  points.insert(points.end(), added.begin(), added.end());
  return points;
}

}  // namespace cocoon::app
