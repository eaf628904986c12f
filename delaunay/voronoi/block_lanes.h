// Fills the SIMD lanes of a block of cells: their corners, from anywhere in memory, and centers.
#pragma once

#include <cstddef>
#include <span>

#include "delaunay/triangulation.h"
#include "delaunay/voronoi/cell_blocks.h"

namespace cocoon {

// block.size and the corners of the batches: of the cells first, first + 1, ..., or of cells
// anywhere. Lanes behind the last cell get its corners once more.
// Preconditions: finite cells, from one to max_block_cells. Complexity: O(cells).
void load_corners(const Triangulation& triangulation, CellId first, std::size_t count,
                  CellBlock& block);
void load_corners(const Triangulation& triangulation, std::span<const CellId> cells,
                  CellBlock& block);

// Fills in the circumcenters as well, as circumcenters_in_doubles() gives them. Meanwhile
// prefetches the points of the next run, if there is one, and the elements of `soon` at its
// vertices.
void load_centers(const Triangulation& triangulation, CellId first, std::size_t count,
                  const ReadSoon& soon, CellBlock& block);

}  // namespace cocoon
