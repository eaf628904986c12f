// Vertices around which the surface between two sides is not one disk.
#pragma once

#include <cstdint>
#include <vector>

#include "cocone/energy/doubtful_region.h"
#include "delaunay/triangulation.h"
#include "geom/execution.h"
#include "geom/id_vector.h"

namespace cocoon {

struct SurfaceFlaws {
  std::vector<VertexId> unused;   // not on the surface
  std::vector<VertexId> pinched;  // the surface divides the cells around them into more than two
};

// Of the vertices of the region, each list in their order. `out`: 1 or 0 for each cell; the
// surface lies between. Complexity: O(cells of the region + their surface facets and what is met
// on turns about their edges); the turns are parallel. A vertex is on one disk iff a walk around
// it, from surface facet to surface facet through one side, meets all of them and no edge twice: a
// simple closed curve in the link of the vertex, a sphere, which it divides in two. Source: ours.
SurfaceFlaws find_surface_flaws(const Triangulation& triangulation, const DoubtfulRegion& region,
                                const IdVector<CellId, std::uint8_t>& out,
                                const Execution& execution = {});

}  // namespace cocoon
