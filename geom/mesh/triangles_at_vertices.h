// The triangles at each vertex of a mesh, as lists.
//
// Use this where vertices are asked for what is around them. For all neighborhoods of a large mesh,
// numbered along a curve, see linked_mesh.h.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geom/execution.h"
#include "geom/ids.h"
#include "geom/triangle_mesh.h"

namespace cocoon {

struct TrianglesAtVertices {
  std::vector<std::uint32_t> begins;  // points + 1
  std::vector<TriangleId> triangles;  // of each vertex in increasing order, each once

  // Empty for a vertex that no triangle uses.
  std::span<const TriangleId> operator[](VertexId v) const {
    const std::size_t begin = begins[v.index()];
    return {triangles.data() + begin, begins[v.index() + 1] - begin};
  }
};

// Precondition: triangles name vertices that are there. Complexity: O(t + v), parallel.
// Deterministic.
TrianglesAtVertices triangles_at_vertices(const TriangleMesh& mesh,
                                          const Execution& execution = {});

}  // namespace cocoon
