// The triangles of a mesh in a tree of their boxes.
#pragma once

#include <array>
#include <vector>

#include "geom/execution.h"
#include "geom/point.h"
#include "geom/search/box_tree.h"
#include "geom/triangle_mesh.h"

namespace cocoon {

// With a copy of the triangles' corners, so that the mesh may go.
struct TriangleTree {
  BoxTree boxes;                              // one for each triangle, in the order of the mesh
  std::vector<std::array<Point, 3>> corners;  // by slot of the tree
};

// Throws InputError if a triangle names a vertex that is not there or has a coordinate that is not
// finite. Complexity: O(t log t), parallel.
TriangleTree triangle_tree(const TriangleMesh& mesh, const Execution& execution = {});

}  // namespace cocoon
