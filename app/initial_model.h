// The model that an update begins with, as its file has it: a surface that is to be closed, or
// points, which are reconstructed first.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/files/model_file.h"
#include "app/job.h"
#include "app/shapes/densify.h"
#include "cocone/known_labels.h"
#include "cocone/reconstruct.h"
#include "geom/id_vector.h"
#include "geom/ids.h"
#include "geom/mesh_check.h"
#include "geom/point.h"
#include "geom/triangle_mesh.h"
#include "io/vertex_properties.h"
#include "update/update_model.h"
#include "update/update_session.h"

namespace cocoon::app {

struct ModelInput {
  std::string name;
  TriangleMesh mesh;  // faces outward; without triangles: points, to be reconstructed
  // Of each vertex or point of the file the one of `mesh`, or none; empty: they are the same.
  IdVector<VertexId, VertexId> vertex_of_file;
  std::optional<DensifiedMesh> dense;  // with --densify: what the points of `mesh` are
};

// Reads the model, or with a `spacing` makes the mesh there dense (read_densified). Counts go to
// the section "input". Throws FileError, and InputError as read_densified.
ModelInput read_model_input(Job& job, const std::string& name, const std::optional<double>& spacing,
                            VertexProperties* properties = nullptr);

// What has been read before, made dense (densified).
ModelInput dense_model_input(Job& job, const std::string& name, ModelFile file, double spacing);

// The closed surface of a model given as points, as stage "initial_model"; its counts go to the
// section "initial_model" of the report. Throws InputError if there is none.
ReconstructResult initial_model(Job& job, const std::string& name, const std::vector<Point>& points,
                                const KnownLabelsSource& known, const ReconstructOptions& options);

// The same of what was read. Warns where it has other handles than the mesh that was made dense.
ReconstructResult initial_model(Job& job, const ModelInput& model,
                                const ReconstructOptions& options);

// A session that begins with the model: with its mesh or, as above, with the surface of its points.
// Whether it was made from points, of which nobody was told yet what is doubtful.
bool begin_session(Job& job, ModelInput model, const UpdateOptions& options,
                   std::optional<UpdateSession>& session);

}  // namespace cocoon::app
