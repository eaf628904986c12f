#include "app/shapes/densify.h"

#include <fmt/format.h>
#include <memory>
#include <utility>

#include "app/files/files.h"
#include "app/files/model_file.h"
#include "cocone/reconstruct.h"
#include "cocone/solid/conforming_samples.h"
#include "cocone/solid/labels_of_solid.h"
#include "cocone/solid/solid_distances.h"
#include "geom/errors.h"
#include "geom/mesh/dense_samples.h"
#include "geom/mesh_check.h"
#include "geom/messages/counted.h"
#include "update/model/hollows.h"
#include "update/model/model_index.h"

namespace cocoon::app {
namespace {

// Whether their surface hangs together as the mesh does, with as many handles and contacts.
bool have_topology_of(const MeshReport& mesh, const std::vector<Point>& samples, bool has_hollow,
                      const KnownLabelsSource& labels, const Execution& execution) {
  const ReconstructResult result =
      reconstruct_tight_with_labels(samples, labels, {.keep_cavities = has_hollow}, execution);
  const MeshReport surface = mesh_check(result.mesh, {}, execution);
  return surface.euler == mesh.euler && surface.components == mesh.components &&
         surface.overfull_edges == mesh.overfull_edges &&
         surface.pinched_vertices == mesh.pinched_vertices;
}

// Adds samples of a closed mesh if those that there are do not suffice. Returns the labels that it
// tells of the cells between them.
KnownLabelsSource conform(Job& job, TriangleMesh mesh, double spacing, DensifiedMesh& dense,
                          const Execution& execution) {
  std::vector<Point>& samples = dense.points;
  const SolidDistances solid(std::make_shared<const TriangleMesh>(std::move(mesh)));
  KnownLabelsSource labels = labels_told_by(solid, samples, labels_of_crossing_cells);
  if (have_topology_of(dense.certificate, samples, dense.has_hollow, labels, execution)) {
    return labels;
  }
  const ConformingSamples more =
      conforming_samples(solid, samples, {.spacing = spacing}, execution);
  job.report().set("input/conforming_samples", more.added.size());
  job.report().set("input/conforming_rounds", more.rounds);
  if (more.without_room > 0) {
    job.report().set("input/conforming_without_room", more.without_room);
  }
  if (!more.added.empty()) {
    job.say("{} more where walls, gaps or edges are closer than {}",
            counted(more.added.size(), "sample"), spacing);
  }
  samples.insert(samples.end(), more.added.begin(), more.added.end());
  return labels_told_by(solid, samples);
}

}  // namespace

DensifiedMesh densified(Job& job, const std::string& name, ModelFile model, double spacing) {
  TriangleMesh& mesh = model.mesh;
  const std::vector<Point> added = timed(job.execution(), "dense_samples", [&] {
    return naming_input(name,
                        [&] { return dense_samples(mesh, {.spacing = spacing}, job.execution()); });
  });
  job.report().set("parameters/densify", spacing);
  job.report().set("input/vertices", mesh.points.size());
  job.report().set("input/added_samples", added.size());
  job.say("{}: {} added to {}", name, counted(added.size(), "sample"),
          counted(mesh.points.size(), "vertex", "vertices"));
  if (added.empty()) {
    job.warn(fmt::format(
        "{}: --densify {} adds no samples, as its triangles are no larger; give a smaller SPACING, "
        "or leave it out",
        name, spacing));
  }
  DensifiedMesh dense;
  dense.points = mesh.points.raw();
  if (model.vertex_of.empty()) {
    for (const VertexId v : mesh.points.ids()) dense.point_of_vertex.push_back(PointId(v.value));
  } else {
    for (const VertexId v : model.vertex_of) dense.point_of_vertex.push_back(PointId(v.value));
  }
  dense.points.insert(dense.points.end(), added.begin(), added.end());
  dense.certificate = mesh_check(mesh, {}, job.execution());
  if (dense.certificate.balanced) {
    dense.has_hollow = has_hollow(ModelIndex(mesh, job.execution()));
    dense.labels = run_step(job.execution(), "conforming", [&](const Execution& nested) {
      return naming_input(name,
                          [&] { return conform(job, std::move(mesh), spacing, dense, nested); });
    });
  } else {
    job.warn(
        name +
        ": is not closed (cocoon check tells where), but the surface of its samples is, and "
        "they alone tell its inside from its outside; where walls are thinner than the spacing "
        "they may be torn");
  }
  return dense;
}

DensifiedMesh read_densified(Job& job, const std::string& path, double spacing,
                             VertexProperties* properties) {
  ModelFile model = read_model(job, path, "input", properties);
  if (model.mesh.triangles.empty()) {
    throw InputError(path +
                     ": --densify needs a mesh, and this file has no triangles; give the mesh, or "
                     "leave --densify out");
  }
  leave_out_unused_vertices(job, path, "input", model, properties);
  orient_model(job, path, "input", model.mesh);
  return densified(job, path, std::move(model), spacing);
}

void warn_of_handles(Job& job, const std::string& path, const DensifiedMesh& dense,
                     const MeshReport& surface) {
  const MeshReport& mesh = dense.certificate;
  if (!mesh.genus || !surface.genus || mesh.components != surface.components) return;
  if (*mesh.genus == *surface.genus) return;
  job.warn(
      fmt::format("{}: the surface of its samples has {}, the mesh {}; sharp edges and thin "
                  "walls need another, mostly a smaller SPACING of --densify; look at the "
                  "result",
                  path, counted(*surface.genus, "handle"), *mesh.genus));
}

}  // namespace cocoon::app
