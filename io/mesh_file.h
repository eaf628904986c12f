// Triangle meshes from and to files, by extension (upper or lower case): .ply .obj .off .stl.
#pragma once

#include <filesystem>

#include "geom/errors.h"
#include "geom/triangle_mesh.h"
#include "io/atomic_file.h"
#include "io/float_rounding.h"
#include "io/mesh_file_options.h"
#include "io/vertex_properties.h"

namespace cocoon {

// Whether the extension is that of a mesh format (such a file may still hold points only).
bool has_mesh_extension(const std::filesystem::path& path);

// Reads a mesh with its vertices and faces in the order of the file. Polygons are cut into
// triangles (io/polygons/triangulate_polygon.h), STL corners are welded exactly; faces and
// triangles without area by their indices alone are left out. `report` counts all of that. Vertices
// without a face are kept. Colors, normals, texture coordinates, unknown properties and elements
// are skipped. Throws FileError, with line or element, for another extension, for what is damaged
// or cut off, for a corner that is no vertex, and for a coordinate that is not a finite number (see
// the options). A count in a header never makes it reserve more than a small multiple of the file's
// size. Complexity: O(bytes), but see triangulate_polygon for polygons that are not convex.
TriangleMesh read_mesh(const std::filesystem::path& path, MeshReadReport& report,
                       const MeshReadOptions& options = {});
TriangleMesh read_mesh(const std::filesystem::path& path);
// The same, and what a PLY file says of its vertices beside their position: one row per vertex.
TriangleMesh read_mesh(const std::filesystem::path& path, MeshReadReport& report,
                       VertexProperties& properties, const MeshReadOptions& options = {});

// Writes vertices and triangles in their order; all bits of the coordinates are kept, but for PLY
// with single_precision and for binary STL: these return what rounding did (else zeros), and leave
// a note in the batch if that is noticeable. The file appears complete or not at all
// (io/atomic_file.h), with a batch together with the rest of it. Throws FileError for another
// extension, for a coordinate that is not finite or a corner that is no vertex (no reader would
// take the file back), and if it cannot be written.
FloatRounding write_mesh(const std::filesystem::path& path, const TriangleMesh& mesh,
                         const MeshWriteOptions& options = {}, FileBatch* batch = nullptr);
// The same with properties of the vertices, one row per vertex; formats other than PLY have no
// place for them. Also throws FileError if there are columns, but not as many rows as vertices.
FloatRounding write_mesh(const std::filesystem::path& path, const TriangleMesh& mesh,
                         const VertexProperties& properties, const MeshWriteOptions& options = {},
                         FileBatch* batch = nullptr);

}  // namespace cocoon
