// PLY, the polygon file format (Turk 1994), in all three encodings.
#pragma once

#include "geom/triangle_mesh.h"
#include "io/atomic_file.h"
#include "io/file_bytes.h"
#include "io/polygons/polygon_soup.h"
#include "io/vertex_properties.h"

namespace cocoon {

// Reads the element "vertex" (properties x, y, z of any scalar type), the element "face" (its list
// vertex_indices or vertex_index of any integer type) and the element "tristrips" (the same list;
// -1 starts a new strip). All other elements and properties are skipped, but the properties of
// vertices are kept if `keep_properties`. docs/formats.md lists the dialects. Throws FileError with
// the line (ascii) or element and byte (binary) for what is damaged, cut off or ambiguous (an
// element or one of these properties given twice). Complexity: O(bytes).
PolygonSoup read_ply(const FileBytes& file, bool keep_properties);

// Writes points, with their properties behind x, y, z, and triangles; a mesh without triangles gets
// an element "face" with count 0. Precondition: one row of properties per point, or no column.
void write_ply(AtomicFile& file, const TriangleMesh& mesh, const VertexProperties& properties,
               const MeshWriteOptions& options);

// The same for points alone, without an element "face".
void write_ply(AtomicFile& file, Points points, const MeshWriteOptions& options);

}  // namespace cocoon
