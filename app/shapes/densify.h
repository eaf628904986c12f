// --densify: a mesh as a dense sampling of its surface.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "app/files/model_file.h"
#include "app/job.h"
#include "cocone/known_labels.h"
#include "geom/id_vector.h"
#include "geom/ids.h"
#include "geom/mesh_check.h"
#include "geom/point.h"
#include "io/vertex_properties.h"

namespace cocoon::app {

struct DensifiedMesh {
  std::vector<Point> points;  // vertices of the mesh, then samples between them
  // Of each vertex of the file, which of them it is; none if no triangle uses it.
  IdVector<VertexId, PointId> point_of_vertex;
  KnownLabelsSource labels;  // where the mesh has inside and outside; empty if it is not closed
  MeshReport certificate;    // of the mesh
  bool has_hollow = false;   // of a closed mesh: one of its parts bounds a hollow
};

// Adds samples about `spacing` apart to a mesh that faces outward and all of whose vertices are
// used, as stage "dense_samples". Of a closed mesh more are added, as stage "conforming", if the
// surface of those has another Euler number, other parts or other contacts than the mesh: to find
// out they are reconstructed. How many goes to the report and the summary. Warns of a mesh that is
// not closed, and where the spacing adds no samples. Throws InputError if the spacing is too small
// for it.
DensifiedMesh densified(Job& job, const std::string& name, ModelFile model, double spacing);

// The same for a file, as stage "read": reads it (read_model), leaves out vertices that no triangle
// uses, with a warning, and turns it outward. Throws FileError, and InputError if it has no
// triangles.
DensifiedMesh read_densified(Job& job, const std::string& path, double spacing,
                             VertexProperties* properties = nullptr);

// Warns if the surface of the samples has more or fewer handles than the mesh, both closed and of
// as many parts. `surface`: its certificate. Says nothing of points that are of no mesh.
void warn_of_handles(Job& job, const std::string& path, const DensifiedMesh& dense,
                     const MeshReport& surface);

}  // namespace cocoon::app
