// What an update begins with, as the files have it.
#pragma once

#include <string>
#include <vector>

#include "app/command_line.h"
#include "app/job.h"
#include "geom/id_vector.h"
#include "geom/ids.h"
#include "geom/point.h"
#include "geom/triangle_mesh.h"
#include "io/vertex_properties.h"
#include "update/stray_samples.h"
#include "update/update_model.h"

namespace cocoon::app {

// The model and the clouds, with names for people.
struct UpdateInput {
  std::string model_name;
  TriangleMesh model;
  // The model is the mesh of a file, as it is: no points that were reconstructed.
  bool is_mesh_of_file = false;
  std::vector<std::string> cloud_names;
  std::vector<std::vector<Point>> clouds;
  // Of the model and of each cloud, to be carried to the output; empty: nothing is carried.
  std::vector<VertexProperties> properties;
  // Of each vertex or point of the model's file the vertex of `model`, or none, where they differ.
  // Empty: the vertices are those of the file.
  IdVector<VertexId, VertexId> vertex_of_file = {};
  // What was left out of each cloud; empty: they were not filtered.
  std::vector<StraySamples> strays = {};
};

// Reads the model and the clouds, which are not filtered yet; a model given as points, or to be
// made dense (--densify), is reconstructed. Throws FileError, and InputError as read_model_input.
UpdateInput read_update_input(Job& job, const UpdateArguments& arguments,
                              const UpdateOptions& options);

// The same with the mesh of a file made dense, as --densify has it. Samples have the properties of
// the nearest vertex of the mesh. Throws InputError as `densified`, and if the samples have no
// surface.
UpdateInput with_dense_model(Job& job, const UpdateInput& input, double spacing,
                             const ReconstructOptions& options);

}  // namespace cocoon::app
