#include "app/densify.h"

#include <memory>
#include <utility>

#include "app/files.h"
#include "cocone/sides_of_solid.h"
#include "geom/counted.h"
#include "geom/dense_samples.h"
#include "geom/errors.h"
#include "geom/mesh_check.h"
#include "geom/working_scale.h"

namespace cocoon::app {

namespace {

// Those of the solid in the triangulation of these samples of it.
KnownSidesSource sides_of(TriangleMesh mesh, Points samples) {
  const double scale = working_scale(samples);
  if (scale != 1) {
    for (Point& p : mesh.points) p = scale * p;
  }
  const auto solid = std::make_shared<const TriangleMesh>(std::move(mesh));
  return [solid](const Triangulation& triangulation, const Execution& execution) {
    return sides_of_solid(triangulation, *solid, {}, execution);
  };
}

}  // namespace

DensifiedMesh read_densified(Job& job, const std::string& path, double spacing) {
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
  DensifiedMesh dense;
  dense.points = mesh.points.raw();
  dense.mesh_vertices = mesh.points.size();
  dense.points.insert(dense.points.end(), added.begin(), added.end());
  if (mesh_check(mesh, {}, job.execution()).balanced) {
    dense.sides = sides_of(std::move(mesh), dense.points);
  } else {
    job.warn(path +
             ": is not closed, so that only the samples tell its inside from its outside; where "
             "walls are thinner than the spacing they may be torn (cocoon check tells where it is "
             "open)");
  }
  return dense;
}

}  // namespace cocoon::app
