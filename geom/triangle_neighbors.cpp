#include "geom/triangle_neighbors.h"

#include <cstddef>

#include "geom/halfedges.h"
#include "geom/large_pages.h"

namespace cocoon {

TriangleNeighbors triangle_neighbors(const TriangleMesh& mesh) {
  TriangleNeighbors neighbors;
  neighbors.reserve(mesh.triangles.size());
  prefer_large_pages(neighbors.raw());
  neighbors.resize(mesh.triangles.size());
  const HalfedgeRings rings = link_halfedges(mesh);
  for (const TriangleId t : mesh.triangles.ids()) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Halfedge halfedge = halfedge_of(t, i);
      if (!rings.has_two_triangles(halfedge)) continue;
      neighbors[t][i] = TriangleId(triangle_of_halfedge(rings.links[halfedge]));
    }
  }
  return neighbors;
}

}  // namespace cocoon
