// The option --manifold.
#pragma once

#include <string>

#include "app/job.h"
#include "geom/mesh_check.h"
#include "geom/triangle_mesh.h"
#include "io/vertex_properties.h"

namespace cocoon::app {

// Where the mesh goes.
struct ManifoldOutput {
  std::string file;
  bool beside_session = false;  // a session is written, too
};

// Splits `mesh` into a 2-manifold (geom/mesh/split_nonmanifold.h), as stage "manifold", and returns
// its certificate, as stage "check"; `properties` of its vertices, if there are any, follow. The
// counts go to the section "manifold" of the report and, if there was something to split, to the
// summary, with a note that the session has none of it. Warns if the file is an STL: it has no
// vertex ids to tell copies apart.
MeshReport make_manifold(Job& job, const ManifoldOutput& output, TriangleMesh& mesh,
                         VertexProperties& properties);

}  // namespace cocoon::app
