// When the extracted surface tells the side of every cell by itself.
//
// Marking, peel and clean-up find out which cells are inside. On well sampled surfaces there is
// nothing to find out. Let S be the extracted surface, and
//
//   1. S is one closed umbrella at each of its vertices (umbrella.h), folded or not;
//   2. its triangles hang together by edges with a good end;
//   3. all its halves (extract_manifold.h) are on one side of it, and one of them is seen from an
//      infinite cell;
//   4. every finite cell has a good vertex.
//
// By 1 and 2 S is a connected closed surface, which divides the 3-sphere in two; by 3 its halves
// are outside. Each triangle has a good corner, by 2: so a good vertex lies on the hull, marks
// begin there, and by 2 come to all others. What they say of a cell is on which of the two sides it
// is: so no two disagree, and by 4 every cell is told. No cell is poor, the peel reaches what is
// OUT, and the clean-up finds no cell undecided and no edge or vertex that S pinches. The result is
// S, as its halves see it. The certificate of a live update (certified_surface.h) asks for more,
// because it has to tell what the extraction would find, too. Source: ours.
#pragma once

#include "cocone/extract_manifold.h"
#include "cocone/umbrella.h"
#include "delaunay/triangulation.h"
#include "geom/execution.h"

namespace cocoon {

// Whether all of this holds. `good`: of the surface's triangles. Complexity: O(triangles), and one
// look at the vertices of each cell if some vertex is not good; parallel.
bool is_certain(const Triangulation& triangulation, const ManifoldSurface& surface,
                const GoodVertices& good, const Execution& execution = {});

}  // namespace cocoon
