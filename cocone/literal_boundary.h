// How the boundary edges of Woo & Dey 2005 differ from edges with one triangle.
#pragma once

#include <cstddef>
#include <cstdint>

#include "geom/id_vector.h"
#include "geom/mesh/halfedges.h"
#include "geom/triangle_mesh.h"

namespace cocoon {

// The paper: an edge of the surface both of whose ends are boundary samples.
struct LiteralBoundary {
  std::size_t edges = 0;
  std::size_t chords = 0;        // of these, edges with more than one triangle: no rim
  std::size_t missed_edges = 0;  // edges with one triangle and an end taken for interior
};

// Counts only: without the missed edges loops do not close, with the chords they branch, so that
// boundary_loops() takes edges with one triangle. boundary_sample[v] = 1: vertex v is one. `rings`:
// those of the surface. Complexity: O(triangles). Errors: InputError for flags or halfedges of
// another surface, by their sizes. Source: Woo & Dey 2005, section 3.2.
LiteralBoundary literal_boundary(const TriangleMesh& surface, const HalfedgeRings& rings,
                                 const IdVector<VertexId, std::uint8_t>& boundary_sample);

}  // namespace cocoon
