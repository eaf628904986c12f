#include "geom/mesh/triangle_neighbors.h"

#include <cstddef>

#include "geom/arrays/large_pages.h"
#include "geom/mesh/halfedges.h"
#include "geom/parallel/parallel_reduce.h"

namespace cocoon {

TriangleNeighbors triangle_neighbors(const TriangleMesh& mesh, const Execution& execution) {
  TriangleNeighbors neighbors;
  neighbors.reserve(mesh.triangles.size());
  prefer_large_pages(neighbors.raw());
  const std::size_t count = mesh.triangles.size();
  neighbors.resize(count);
  const HalfedgeRings rings = link_halfedges(mesh, execution);
  parallel_chunks(execution, count, coarse_grain(count), [&](std::size_t begin, std::size_t end) {
    for (TriangleId t(begin); t.index() < end; ++t) {
      for (std::size_t i = 0; i < 3; ++i) {
        const Halfedge halfedge = halfedge_of(t, i);
        if (!rings.has_two_triangles(halfedge)) continue;
        neighbors[t][i] = TriangleId(triangle_of_halfedge(rings.links[halfedge]));
      }
    }
  });
  return neighbors;
}

}  // namespace cocoon
