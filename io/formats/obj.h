// OBJ (Wavefront): the statements v and f.
#pragma once

#include "geom/triangle_mesh.h"
#include "io/atomic_file.h"
#include "io/file_bytes.h"
#include "io/polygons/polygon_soup.h"

namespace cocoon {

// Reads `v x y z` (what follows on the line is not read: a weight, colors) and `f`, once `fo`,
// whose corners are i, i/t, i//n or i/t/n, with i counted from 1, or from -1 backwards. All other
// statements are skipped. A backslash at the end of such a line, and only there, continues it; #
// starts a comment. Texture coordinates and normals do not split vertices. Throws FileError with
// the line for what is no number, an index 0, or if there is no vertex at all. Complexity:
// O(bytes).
PolygonSoup read_obj(const FileBytes& file);

void write_obj(AtomicFile& file, const TriangleMesh& mesh);
void write_obj(AtomicFile& file, Points points);

}  // namespace cocoon
