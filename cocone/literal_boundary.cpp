#include "cocone/literal_boundary.h"

#include "geom/require_size.h"

namespace cocoon {

LiteralBoundary literal_boundary(const TriangleMesh& surface, const HalfedgeRings& rings,
                                 const IdVector<VertexId, std::uint8_t>& boundary_sample) {
  require_size("literal_boundary", "linked halfedges", rings.links.size(),
               3 * surface.triangles.size());
  require_size("literal_boundary", "flags of vertices", boundary_sample.size(),
               surface.points.size());
  LiteralBoundary result;
  for (Halfedge h = 0; h < rings.links.size(); ++h) {
    if (!rings.has_edge(h) || !rings.is_first(h)) continue;
    const auto [a, b] = ends_of_halfedge(surface, h);
    const bool joins_samples = boundary_sample[a] != 0 && boundary_sample[b] != 0;
    result.edges += joins_samples ? 1U : 0U;
    result.chords += joins_samples && !rings.is_open(h) ? 1U : 0U;
    result.missed_edges += !joins_samples && rings.is_open(h) ? 1U : 0U;
  }
  return result;
}

}  // namespace cocoon
