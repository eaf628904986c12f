#include "app/update_input.h"

#include <utility>
#include <vector>

#include "app/files/carried_properties.h"
#include "app/files/files.h"
#include "app/files/model_file.h"
#include "app/initial_model.h"
#include "geom/search/equal_points.h"

namespace cocoon::app {

namespace {

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
    VertexProperties& properties = input.properties[0];
    if (model.dense) {
      properties = properties_of_samples(properties, model.mesh.points.span());
    }
    properties = select_rows(properties, rows_of(initial));
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

}  // namespace

UpdateInput read_update_input(Job& job, const UpdateArguments& arguments,
                              const UpdateOptions& options) {
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
    input.is_mesh_of_file = true;
  }
  return input;
}

UpdateInput with_dense_model(Job& job, const UpdateInput& input, double spacing,
                             const ReconstructOptions& options) {
  UpdateInput result = input;
  result.is_mesh_of_file = false;
  result.vertex_of_file = {};
  ModelInput model =
      dense_model_input(job, input.model_name, {input.model, input.vertex_of_file}, spacing);
  reconstruct(job, options, model, result);
  return result;
}

}  // namespace cocoon::app
