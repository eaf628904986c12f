#include "cocone/literal_boundary.h"

#include "geom/messages/require_size.h"

namespace cocoon {

LiteralBoundary literal_boundary(const TriangleMesh& surface, const HalfedgeRings& rings,
                                 const IdVector<VertexId, std::uint8_t>& boundary_sample) {
  require_size("literal_boundary", "linked halfedges", rings.links.size(),
               3 * surface.triangles.size());
  require_size("literal_boundary", "flags of vertices", boundary_sample.size(),
               surface.points.size());
  LiteralBoundary result;
  for (Halfedge h = 0; h < rings.links.size(); ++h) {
    const auto [a, b] = ends_of_halfedge(surface, h);
    if (boundary_sample[a] == 0 || boundary_sample[b] == 0) {
      result.missed_edges += rings.is_open(h) ? 1U : 0U;
    } else if (rings.has_edge(h) && rings.is_last(h)) {
      ++result.edges;
      result.chords += rings.is_open(h) ? 0U : 1U;
    }
  }
  return result;
}

}  // namespace cocoon
