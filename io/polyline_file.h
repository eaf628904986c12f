// Closed polylines (boundary loops) as a file that viewers show.
#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "geom/ids.h"
#include "geom/point.h"
#include "io/atomic_file.h"

namespace cocoon {

// Writes an OBJ file with one statement `l` a loop, which ends with its first vertex again. Only
// the points that a loop uses are written, in the order of their first use. A loop lists each of
// its vertices once; no loops make a file without vertices. Throws FileError for another extension
// than .obj, for a vertex that is none of the points, and if the file cannot be written (then the
// old file is intact). With a batch it appears together with the rest of it. Complexity: O(points +
// vertices of the loops).
void write_polylines(const std::filesystem::path& path, Points points,
                     std::span<const std::vector<VertexId>> loops, FileBatch* batch = nullptr);

}  // namespace cocoon
