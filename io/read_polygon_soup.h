// Reads a mesh file of any format, before its faces are cut into triangles.
#pragma once

#include <filesystem>

#include "io/polygons/polygon_soup.h"

namespace cocoon {

// Dispatches by extension. Points that are not finite are noted in the result, corners are not
// checked: both is left to what the caller makes of it. Throws FileError for another extension than
// .ply .obj .off .stl and for what the reader of the format refuses. `keep_properties`: see
// io/vertex_properties.h; only PLY has any. Complexity: that of the format's reader.
PolygonSoup read_polygon_soup(const std::filesystem::path& path, bool keep_properties = false);

}  // namespace cocoon
