// OFF, the object file format (Geomview), as text.
#pragma once

#include "geom/triangle_mesh.h"
#include "io/atomic_file.h"
#include "io/file_bytes.h"
#include "io/polygons/polygon_soup.h"

namespace cocoon {

// Reads OFF with any of the prefixes ST, C, N, in any order: the first three numbers of a vertex
// line are its position, what follows (normal, color, texture) is not read, nor are colors behind
// faces. The keyword may be missing, and the counts may stand on its line; # starts a comment. One
// vertex and one face a line. Throws FileError with the line for what is no number, damaged or cut
// off, and for 4OFF, nOFF and OFF BINARY, which are not read. Complexity: O(bytes).
PolygonSoup read_off(const FileBytes& file);

void write_off(AtomicFile& file, const TriangleMesh& mesh);
void write_off(AtomicFile& file, Points points);

}  // namespace cocoon
