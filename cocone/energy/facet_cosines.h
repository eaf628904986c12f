// The angles between the facets of cells and their circumballs, many at once in SIMD lanes.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "delaunay/voronoi/cell_blocks.h"

namespace cocoon {

// Of the cells of a block.
struct FacetCosines {
  using Batch = std::array<std::array<double, circumcenter_batch_size>, 4>;
  alignas(64) std::array<Batch, max_block_cells / circumcenter_batch_size> cosines;
  std::array<std::uint8_t, max_block_cells> flat;  // 1: the cell is

  // For the facet opposite to corner j of cell k: BallCosines::of, but that flat cells are not
  // looked through.
  double at(std::size_t k, std::size_t j) const {
    return cosines[k / circumcenter_batch_size][j][k % circumcenter_batch_size];
  }
};

// Functions of the corners and the centers, not of the order of the corners; the same bits whatever
// the instruction set. `flat_ratio`: of BallCosines. Complexity: O(cells).
void facet_cosines(const CellBlock& block, double flat_ratio, FacetCosines& result);

}  // namespace cocoon
