// The file of a model: a surface that is to be closed, or points.
#pragma once

#include <string>

#include "app/job.h"
#include "geom/id_vector.h"
#include "geom/triangle_mesh.h"
#include "io/vertex_properties.h"

namespace cocoon::app {

struct ModelFile {
  TriangleMesh mesh;  // of a file without triangles the points alone
  // Of each vertex or point of the file, the one of `mesh`, or none if it was left out, for not
  // being finite (points only) or since no triangle uses it; empty: they are the same.
  IdVector<VertexId, VertexId> vertex_of;
};

// Reads it as read_shape (app/files/files.h). Where the mesh is open only because its triangles do
// not share vertices, as some programs write them, vertices at equal places are taken as one, as
// those of STL files are: if that leaves fewer open edges. The summary says so, and the section's
// "welded_vertices" counts them, "faces_left_out" triangles that vanish by it; of their properties
// those of the first are kept. Triangles at the place of another one are left out with a warning
// (leave_out_repeated_triangles()), which "repeated_triangles" counts.
// Complexity: O(v + t) without equal places, else as mesh_check.
ModelFile read_model(Job& job, const std::string& path, const std::string& section,
                     VertexProperties* properties = nullptr);

// Leaves out vertices that no triangle uses, with their properties (nullptr: there are none). In
// `vertex_of` those at the place of another one that is used become that one, the others none.
// Warns of the places where none is used; the section's "unused_vertices" counts them. Complexity:
// O(v + t), and O(v log v) if there are any.
void leave_out_unused_vertices(Job& job, const std::string& path, const std::string& section,
                               ModelFile& model, VertexProperties* properties = nullptr);

// Turns the mesh read so that it faces outward (orient_outward()). The summary says so, and the
// section's "turned_triangles" counts. Complexity: O(v).
void orient_model(Job& job, const std::string& path, const std::string& section,
                  TriangleMesh& mesh);

}  // namespace cocoon::app
