// The option --manifold.
#pragma once

#include <string>

#include "app/job.h"
#include "geom/triangle_mesh.h"
#include "io/vertex_properties.h"

namespace cocoon::app {

// Splits `mesh` into a 2-manifold (geom/mesh/split_nonmanifold.h), as stage "manifold";
// `properties` of its vertices, if there are any, follow. The counts go to the section "manifold"
// of the report and, if there was something to split, to the summary. Returns whether there was.
// Warns if `file`, where the mesh will be written, is an STL: it has no vertex ids to tell copies
// apart.
bool make_manifold(Job& job, const std::string& file, TriangleMesh& mesh,
                   VertexProperties& properties);

// What is to be said if a session is written beside such a mesh.
std::string note_of_parted_session();

}  // namespace cocoon::app
