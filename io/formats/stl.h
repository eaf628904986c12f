// STL (stereolithography), binary and ASCII.
#pragma once

#include "geom/triangle_mesh.h"
#include "io/atomic_file.h"
#include "io/file_bytes.h"
#include "io/polygons/polygon_soup.h"

namespace cocoon {

// Reads the facets and welds their corners exactly: corners with equal coordinates (-0 equals 0)
// become one vertex, in the order of first appearance; no tolerance, so that the mesh holds what
// the file says. Several solids become one mesh. Normals are not read (the corners' order is). A
// file of 84 + 50 n bytes that announces n facets is binary, whatever its first word, also with up
// to 49 bytes behind them; another one that begins with "solid" is text. Throws FileError for what
// is neither, damaged, cut off (also a text without its last endsolid: it may be half a file).
// Complexity: O(bytes) expected: corners are welded by a hash table.
PolygonSoup read_stl(const FileBytes& file);

// Binary (or, with options.ascii, text), with unit normals, zero for a degenerate triangle. Binary
// STL holds floats: coordinates are rounded, so distinct vertices can fall together, and vertices
// without a triangle are lost in either encoding. Text keeps all bits. Throws FileError if a
// coordinate is too large for float.
void write_stl(AtomicFile& file, const TriangleMesh& mesh, const MeshWriteOptions& options);

}  // namespace cocoon
