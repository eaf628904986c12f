#include "geom/triangle_mesh.h"

#include <algorithm>

namespace cocoon {

void canonicalize_triangles(TriangleMesh& mesh) {
  for (Triangle& triangle : mesh.triangles) {
    std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()),
                triangle.end());
  }
  std::sort(mesh.triangles.begin(), mesh.triangles.end());
}

}  // namespace cocoon
