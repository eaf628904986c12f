// Manifold extraction: one sheet out of the slightly thickened set of candidates.
//
// Where four samples nearly lie on a circle, all facets of a flat tetrahedron may be candidates.
// The surface as seen from one side is connected: a half-facet is a candidate seen from one of its
// two cells (as such it is a FacetId). From it, rotate about an edge through the cells on its side
// to the first candidate met: that is a half-facet again, and rotating back returns. So half-facets
// fall into classes, the sides of sheets.
#pragma once

#include <cstddef>
#include <vector>

#include "cocone/facet_set.h"
#include "delaunay/triangulation.h"
#include "geom/execution.h"

namespace cocoon {

struct ManifoldSurface {
  FacetSet facets;
  // One id per facet, ascending: the facet seen from the side whose class was kept. Normals of
  // facet_vertices(mirror(half)) point to that side: outward where the class was seen from outside.
  std::vector<FacetId> halves;
  std::size_t components = 0;  // classes kept
  std::size_t dropped = 0;     // candidates not on the surface
  std::size_t two_sided = 0;   // facets with both halves in one class: not orientable there
};

// Rotation passes over an edge iff one of its ends has an umbrella (`umbrella` as from
// prune_sharp_edges); a half-facet that would meet its own back side has no neighbor there.
// Kept are: of the classes seen from infinite cells, largest first, each one that shares no facet
// with what is kept (else it is the back of it); then of the other classes, largest first, those
// that share no vertex with what is kept. Equal sizes: the class with the lexicographically smaller
// first facet goes first; if it is the same one, the class that sees its positive side.
// Complexity: O(cells + degrees of the candidates' edges). Independent of ids and order.
// Source: Amenta, Choi, Dey & Leekha 2002 (manifold extraction); spec 5.3 variant W, section 12.
ManifoldSurface extract_manifold(const Triangulation& triangulation, const FacetSet& candidates,
                                 const VertexSet& umbrella, const Execution& execution = {});

}  // namespace cocoon
