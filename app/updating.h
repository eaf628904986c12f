// An update as `update` and `demo` run it, from what was read to the outputs.
#pragma once

#include <string>
#include <vector>

#include "app/job.h"
#include "geom/id_vector.h"
#include "geom/point.h"
#include "geom/triangle_mesh.h"
#include "io/mesh_file_options.h"
#include "io/vertex_properties.h"
#include "update/stray_samples.h"
#include "update/update_model.h"
#include "update/update_session.h"

namespace cocoon::app {

// What goes in: the model and the clouds, with names for people.
struct UpdateInput {
  std::string model_name;
  TriangleMesh model;
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

// What to write; empty: not wanted.
struct UpdateOutput {
  std::string mesh;
  std::string map;  // one line per vertex of the model's file: its new index, or -1
  std::string html;
  MeshWriteOptions writing;
  bool manifold = false;
};

// Updates (by the session, if there is one, whose model is then input.model), writes the outputs
// (which wait for job.finish), and fills in the report. Throws InputError, with the library's
// explanation, if there is no updated model; then nothing is written.
void update_and_write(Job& job, const UpdateInput& input, const UpdateOptions& options,
                      const UpdateOutput& output, UpdateSession* session = nullptr);

}  // namespace cocoon::app
