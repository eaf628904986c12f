// The cross-check of io/: CGAL's mesh readers in the project's types.
#pragma once

#include <filesystem>

#include "geom/triangle_mesh.h"

namespace cocoon::ref {

// Reads .ply, .obj, .off or .stl with CGAL's polygon soup readers (no vertices are merged but for
// STL). Polygons are cut as fans. Throws FileError if CGAL cannot read the file.
TriangleMesh cgal_read_mesh(const std::filesystem::path& path);

}  // namespace cocoon::ref
