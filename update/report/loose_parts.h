// Parts of an updated surface that hang together with nothing of the model.
#pragma once

#include <cstddef>
#include <span>

#include "geom/ids.h"
#include "geom/triangle_mesh.h"

namespace cocoon {

struct LooseParts {
  std::size_t count = 0;
  // Of the largest (of several the one with the first vertex): its triangles, its first vertex.
  std::size_t triangles = 0;
  VertexId at = {};
};

// Parts all of whose vertices are of clouds, from `first_new` on: a body that was added, or a scan
// that ends before it meets the model. `triangles`: those of the updated mesh, or of these at least
// all that have such a vertex. Complexity: O(triangles + new vertices). Source: ours.
LooseParts loose_parts(std::span<const Triangle> triangles, VertexId first_new);

}  // namespace cocoon
