#include <fmt/format.h>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "app/arguments/update_options.h"
#include "app/commands.h"
#include "app/console/interrupt.h"
#include "app/files/carried_properties.h"
#include "app/files/files.h"
#include "app/files/pending_clouds.h"
#include "app/files/session_file.h"
#include "app/initial_model.h"
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

// From which point of a cloud each of its file is (empty: they are the same) to its vertex.
void follow(const IdVector<PointId, VertexId>& vertex_of_point,
            IdVector<VertexId, VertexId>& of_file) {
  if (of_file.empty()) {
    of_file = IdVector<VertexId, VertexId>(vertex_of_point.raw());
    return;
  }
  for (VertexId& at : of_file.raw()) {
    if (!at.is_none()) at = vertex_of_point[PointId(at.value)];
  }
}

// The vertex of each of the points, also of those that are equal to another.
IdVector<PointId, VertexId> vertices_of(Points points, const ReconstructResult& surface) {
  IdVector<PointId, VertexId> vertex_of_point(points.size());
  for (const VertexId v : surface.point_of_vertex.ids()) {
    vertex_of_point[surface.point_of_vertex[v]] = v;
  }
  for (const RepeatedPoint& repeated : repeated_points(points)) {
    vertex_of_point[PointId(repeated.point)] = vertex_of_point[PointId(repeated.first)];
  }
  return vertex_of_point;
}

// A model given as points, with their properties.
void reconstruct(Job& job, const ReconstructOptions& options, ModelInput& model,
                 UpdateInput& input) {
  ReconstructResult initial = initial_model(job, model, options);
  if (!input.properties.empty()) {
    std::vector<RowOrigin> origins;
    for (const PointId point : initial.point_of_vertex) origins.push_back({0, point.index()});
    input.properties[0] = select_rows(input.properties[0], origins);
  }
  const IdVector<PointId, VertexId> vertex_of_point =
      vertices_of(model.mesh.points.span(), initial);
  if (model.dense) {
    for (const PointId p : model.dense->point_of_vertex) {
      input.vertex_of_file.push_back(p.is_none() ? VertexId() : vertex_of_point[p]);
    }
  } else {
    input.vertex_of_file = std::move(model.vertex_of_file);
    follow(vertex_of_point, input.vertex_of_file);
  }
  input.model = std::move(initial.mesh);
}

// The model and the clouds; a model given as points, or made dense, is reconstructed.
UpdateInput read_input(const UpdateArguments& arguments, const UpdateOptions& options, Job& job) {
  UpdateInput input;
  if (holds_properties(arguments.mesh)) input.properties.resize(1 + arguments.clouds.size());
  const auto properties_of = [&](std::size_t i) {
    return input.properties.empty() ? nullptr : &input.properties[i];
  };
  input.model_name = arguments.model;
  ModelInput model = read_model_input(job, arguments.model, arguments.densify, properties_of(0));
  if (!model.dense) {
    require_replaceable(arguments.mesh, arguments.model, model.mesh.triangles.size());
  }
  for (const std::string& cloud : arguments.clouds) {
    input.cloud_names.push_back(cloud);
    input.clouds.push_back(
        read_cloud(job, cloud, "input", properties_of(input.cloud_names.size())));
  }
  if (model.mesh.triangles.empty()) {
    reconstruct(job, options.reconstruct, model, input);
  } else {
    input.model = std::move(model.mesh);
    input.vertex_of_file = std::move(model.vertex_of_file);
  }
  return input;
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
  update_and_write(
      job, input, options,
      {arguments.mesh, arguments.map, arguments.html, arguments.writing, arguments.manifold},
      &session);
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
  UpdateInput input = read_input(arguments, options, job);
  refuse_model_as_cloud(input);
  filter_input(job, filter, input);
  update_and_write(
      job, input, options,
      {arguments.mesh, arguments.map, arguments.html, arguments.writing, arguments.manifold});
  job.finish();
}

}  // namespace cocoon::app
