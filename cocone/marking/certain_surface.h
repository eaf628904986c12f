// When the extracted surface tells the side of every cell by itself.
//
// Marking, peel and clean-up find out which cells are inside. On well sampled surfaces there is
// nothing to find out. Let S be the extracted surface, and
//
//   1. S is one closed umbrella at each of its vertices (umbrella.h), folded or not;
//   2. it was found in one walk (extract_manifold.h), and an infinite cell sees a half of it;
//   3. of two folded vertices with an edge of S one has no other folded neighbor;
//   4. every finite cell has a good vertex.
//
// By 1 and 2 S is a connected closed surface, which divides the 3-sphere in two. A half is kept
// when the walk meets it as the first from another one, and what it passes over is not in S: so by
// 2 all halves are on one side, and that is outside. Triangles hang together over edges with a good
// end: over others, by 3, around one end. So each has a good corner, one of these lies on the hull,
// marks begin there and come to all good vertices. What they say of a cell is on which of the two
// sides it is: so no two disagree, and by 4 every cell is told. No cell is poor, the peel reaches
// what is OUT, and the clean-up finds no cell undecided and no edge or vertex that S pinches. The
// result is S, as its halves see it. The certificate of a live update (certified_surface.h) asks
// for more, because it has to tell what the extraction would find, too. Source: ours.
#pragma once

#include "cocone/extract_manifold.h"
#include "cocone/umbrella.h"
#include "delaunay/triangulation.h"
#include "geom/execution.h"

namespace cocoon {

// Whether all of this holds. `vertices`: of the surface's triangles. Complexity: O(halves); if some
// vertex is not good also one look at the corners of each triangle and cell, parallel.
bool is_certain(const Triangulation& triangulation, const ManifoldSurface& surface,
                const GoodVertices& vertices, const Execution& execution = {});

}  // namespace cocoon
