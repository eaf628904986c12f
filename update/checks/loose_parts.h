// Parts of an updated surface that share no vertex with what stays of the model.
#pragma once

#include <cstddef>
#include <vector>

#include "geom/ids.h"
#include "geom/triangle_mesh.h"

namespace cocoon {

struct LooseParts {
  std::size_t count = 0;
  // Of the largest (of several the one with the first vertex):
  std::size_t triangles = 0;
  VertexId at = {};  // its lexicographically first vertex, as the updated mesh numbers it
  // Of each part the diagonal of its box.
  std::vector<double> extents;
};

// Triangles that share a vertex are of one part. Counted are parts all of whose vertices are of
// clouds, from `first_new` on (first_vertex_of_clouds): a body that was added, or a scan that ends
// before it meets the model. `mesh`: the updated one. Complexity: O(triangles + new vertices).
// Source: ours.
LooseParts loose_parts(const TriangleMesh& mesh, VertexId first_new);

}  // namespace cocoon
