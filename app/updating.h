// What `update`, `demo` and `watch` share: options, words, the run itself, and its outputs.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/command_line.h"
#include "app/job.h"
#include "app/report/findings.h"
#include "app/shapes/cloud_filter.h"
#include "cocone/reconstruct.h"
#include "geom/execution.h"
#include "geom/mesh_check.h"
#include "geom/point.h"
#include "geom/triangle_mesh.h"
#include "io/vertex_properties.h"
#include "update/stray_samples.h"
#include "update/update_model.h"
#include "update/update_session.h"

namespace cocoon::app {

// The library's options with what the user has set. --rho is that of the clouds' boundaries, and
// then the only one that is tried; the other parameters hold for the updated model and the clouds,
// --alpha for the first trial of each. Mode::paper: paper_update_options().
UpdateOptions update_options(const SurfaceArguments& arguments);

// What the user says of groups of the model.
RegionOverrides region_overrides(const UpdateArguments& arguments);

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

// Makes a session that begins with the closed surface of a model given as points, as stage
// "initial_model"; its counts go to the section "initial_model" of the report. Throws InputError if
// there is none.
void begin_session(Job& job, const std::string& name, const std::vector<Point>& points,
                   const KnownLabelsSource& known, const UpdateOptions& options,
                   std::optional<UpdateSession>& session);

// What is doubtful about the surface of an updated model, `surface` with its mesh, made from
// `points`. Long edges beside short ones are no gaps here: they are at the rim of every cloud that
// is denser than the model. What the stages counted is of the whole model, and nothing that this
// update could be told of. Noise is always a warning: few models have it. `left`: options that the
// command has. `certificate` gets that of the surface. Complexity: as surface_doubts.
std::vector<Finding> findings_of_update(const ReconstructResult& surface, Points points,
                                        NoiseFilter filter, const OptionsLeft& left,
                                        const Execution& execution, MeshReport& certificate);

// What the findings of an update are to say of its filter.
NoiseFilter noise_filter_of_update(bool filtered);

// Of clouds whose samples lie much farther apart in some places than in others (spacing_range).
std::vector<std::string> notes_of_uneven_clouds(const UpdateResult& result,
                                                const std::vector<std::string>& names,
                                                const DensityOptions& options);

// Messages of the library number the clouds ("cloud 1 of 2"); people know them by their files.
std::string with_cloud_names(const std::string& message, const std::vector<std::string>& names);

// And that the program has an option for what they advise.
std::string with_option_names(std::string message);

// What to write; empty: not wanted.
struct UpdateOutput {
  std::string mesh;
  std::string map;  // one line per vertex of the model's file: its new index, or -1
  std::string html;
  MeshWriteOptions writing;
  bool manifold = false;
};

// Whether a cloud is no scan but the model itself, with all of its vertices, as where somebody
// gives it beside the session that has it. Noise may give it a rim, and then it would replace
// itself. Complexity: O(1) for clouds with fewer points, else O(n log n).
bool is_model_itself(const std::vector<Point>& cloud, const TriangleMesh& model);

// The options of the filter, in the section "parameters", and "input/thinned_points".
void add_filter(JsonReport& report, const CloudFilter& filter, std::size_t thinned_points);

// The rest of the section "parameters": what clouds and model are reconstructed with.
void add_update_parameters(JsonReport& report, const UpdateOptions& options);

// Takes samples too close to others, and stray ones, out of the clouds, with their properties, as
// the filter says; counts go to the report, of strays to section "noise", and to the summary.
void filter_clouds(Job& job, const CloudFilter& filter, UpdateInput& input);

// The closed surface of a model given as points, as stage "initial_model"; its counts go to the
// section "initial_model" of the report. Throws InputError if there is none.
ReconstructResult initial_model(Job& job, const std::string& name, const std::vector<Point>& points,
                                const KnownLabelsSource& known, const ReconstructOptions& options);

// Updates (by the session, if there is one, whose model is then input.model), writes the outputs
// (which wait for job.finish), and fills in the report. Throws InputError, with the library's
// explanation, if there is no updated model; then nothing is written.
void update_and_write(Job& job, const UpdateInput& input, const UpdateOptions& options,
                      const UpdateOutput& output, UpdateSession* session = nullptr);

}  // namespace cocoon::app
