// The one order of cells that stands for a triangulation, whatever way it was built.
#pragma once

#include <cstddef>

#include "delaunay/cell_pool.h"

namespace cocoon {

// Renumbers the cells of `pool` in place and drops the free ones: finite cells first, then the
// infinite ones, each sorted by their vertex records. In a finite record the vertices increase,
// but for the last two, which are swapped where the orientation wants it; an infinite record
// starts with its smallest vertex and ends with the vertex at infinity. Equal triangulations become
// equal arrays. Returns the number of finite cells. Leaves pool.marks and pool.free empty.
// Complexity: O(cells) for bounded vertex degrees; 8 bytes per cell of extra memory.
std::size_t canonicalize_cells(CellPool& pool, std::size_t num_vertices);

}  // namespace cocoon
