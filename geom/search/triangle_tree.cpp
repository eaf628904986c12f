#include "geom/search/triangle_tree.h"

#include <cstdint>

#include "geom/box.h"

namespace cocoon {

TriangleTree triangle_tree(const TriangleMesh& mesh, const Execution& execution) {
  std::vector<Box> boxes;
  boxes.reserve(mesh.triangles.size());
  for (const TriangleId t : mesh.triangles.ids()) {
    boxes.push_back(box_of(finite_corners_of(mesh, t)));
  }
  TriangleTree tree{BoxTree(boxes, execution), {}};
  tree.corners.reserve(boxes.size());
  for (const std::uint32_t t : tree.boxes.items()) {
    tree.corners.push_back(corners_of(mesh, TriangleId(t)));
  }
  return tree;
}

}  // namespace cocoon
