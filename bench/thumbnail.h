// Small pictures of meshes, for pages that show many of them.
#pragma once

#include <string>

#include "geom/box.h"
#include "geom/triangle_mesh.h"

namespace cocoon::bench {

// A square picture of size x size pixels as a BMP file with a palette: `mesh` seen obliquely from
// above, in parallel projection that fits `frame`, lit from the viewer's left. Triangles seen from
// outside are gray, those seen from inside red, so that holes and wrong orientation catch the eye;
// of several at a pixel the nearest counts. Complexity: O(triangles + pixels they cover).
std::string thumbnail_bmp(const TriangleMesh& mesh, const Box& frame, int size);

}  // namespace cocoon::bench
