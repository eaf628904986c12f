// The one order of cells that stands for a triangulation, whatever way it was built.
#pragma once

#include "delaunay/triangulation.h"

namespace cocoon {

// The same triangulation with its cells renumbered: finite cells first, then the infinite ones,
// each sorted by their vertex records. In a finite record the vertices increase, but for the last
// two, which are swapped where the orientation wants it; an infinite record starts with its
// smallest vertex and ends with the vertex at infinity. So triangulations that are equal as sets of
// cells on equally numbered vertices become equal arrays: `cocoon delaunay` writes its cells in
// this order. Neighbors in space become neighbors in memory. Complexity: O(cells) for bounded
// vertex degrees; 41 bytes per cell of extra memory meanwhile.
Triangulation canonical_order(Triangulation triangulation);

}  // namespace cocoon
