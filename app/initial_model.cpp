#include "app/initial_model.h"

#include <fmt/format.h>
#include <utility>

#include "app/files/files.h"
#include "app/files/model_file.h"
#include "app/report/reconstruct_report.h"
#include "app/report/update_findings.h"

namespace cocoon::app {

namespace {

// Points that the model leaves out are no part of what is updated: nobody else would tell.
void warn_of_unused(Job& job, const std::string& name, const ReconstructResult& model,
                    Points points) {
  MeshReport certificate;
  for (const Finding& finding : findings_of_update(model, points, NoiseFilter::no_option, {},
                                                   job.execution(), certificate)) {
    if (finding.kind == "unused") job.warn(fmt::format("{}: {}", name, finding.message));
  }
}

// `triangles`: of its mesh, which may be elsewhere.
void require_initial_model(Job& job, const std::string& name, const ReconstructResult& model,
                           std::size_t triangles, Points points,
                           const ReconstructOptions& options) {
  require_surface(job, name, model, points, options, remedies_of_model());
  job.report().set("initial_model/points", model.points);
  job.report().set("initial_model/duplicates", model.duplicates);
  job.report().set("initial_model/unused_points", model.unused_points);
  job.report().set("initial_model/triangles", triangles);
}

KnownLabelsSource labels_of(const ModelInput& model) {
  return model.dense ? model.dense->labels : KnownLabelsSource();
}

// The samples have the hollows that the mesh has.
ReconstructOptions with_hollows_of(const ModelInput& model, ReconstructOptions options) {
  if (model.dense && model.dense->has_hollow) options.keep_cavities = true;
  return options;
}

void warn_of_handles(Job& job, const ModelInput& model, const TriangleMesh& surface) {
  if (!model.dense) return;
  warn_of_handles(job, model.name, *model.dense, mesh_check(surface, {}, job.execution()));
}

ModelInput of_dense(const std::string& name, DensifiedMesh dense) {
  ModelInput model;
  model.name = name;
  model.mesh.points = IdVector<VertexId, Point>(std::exchange(dense.points, {}));
  model.dense = std::move(dense);
  return model;
}

}  // namespace

ModelInput read_model_input(Job& job, const std::string& name, const std::optional<double>& spacing,
                            VertexProperties* properties) {
  if (spacing) return of_dense(name, read_densified(job, name, *spacing, properties));
  ModelInput model;
  model.name = name;
  ModelFile file = read_model(job, name, "input", properties);
  if (!file.mesh.triangles.empty()) {
    leave_out_unused_vertices(job, name, "input", file, properties);
    orient_model(job, name, "input", file.mesh);
  }
  model.mesh = std::move(file.mesh);
  model.vertex_of_file = std::move(file.vertex_of);
  return model;
}

ModelInput dense_model_input(Job& job, const std::string& name, ModelFile file, double spacing) {
  return of_dense(name, densified(job, name, std::move(file), spacing));
}

ReconstructResult initial_model(Job& job, const std::string& name, const std::vector<Point>& points,
                                const KnownLabelsSource& known, const ReconstructOptions& options) {
  ReconstructResult result =
      run_step(job.execution(), "initial_model", [&](const Execution& nested) {
        return naming_input(
            name, [&] { return reconstruct_tight_with_labels(points, known, options, nested); });
      });
  require_initial_model(job, name, result, result.mesh.triangles.size(), points, options);
  if (result.unused_points > 0) warn_of_unused(job, name, result, points);
  return result;
}

ReconstructResult initial_model(Job& job, const ModelInput& model,
                                const ReconstructOptions& options) {
  ReconstructResult result = initial_model(job, model.name, model.mesh.points.raw(),
                                           labels_of(model), with_hollows_of(model, options));
  warn_of_handles(job, model, result.mesh);
  return result;
}

bool begin_session(Job& job, ModelInput model, const UpdateOptions& options,
                   std::optional<UpdateSession>& session) {
  if (!model.mesh.triangles.empty()) {
    session.emplace(std::move(model.mesh), options);
    session->limit_undo(0);  // no command goes back
    return false;
  }
  const std::vector<Point>& points = model.mesh.points.raw();
  run_step(job.execution(), "initial_model", [&](const Execution& nested) {
    UpdateOptions of_session = options;
    of_session.reconstruct = with_hollows_of(model, options.reconstruct);
    naming_input(model.name,
                 [&] { session.emplace(points, of_session, nested, labels_of(model)); });
    session->limit_undo(0);
  });
  require_initial_model(job, model.name, session->reconstruction(),
                        session->model().triangles.size(), points, options.reconstruct);
  warn_of_handles(job, model, session->model());
  return true;
}

}  // namespace cocoon::app
