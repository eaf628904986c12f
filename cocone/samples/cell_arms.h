// The arms of cells: from the corners to the circumcenter, many at once in SIMD lanes.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "delaunay/triangulation.h"
#include "delaunay/voronoi/cell_blocks.h"
#include "geom/id_vector.h"
#include "geom/point.h"

namespace cocoon {

// Of the arms of the cells of a block, by batches, corners, and cells of the batch.
struct SquaredArms {
  using Batch = std::array<std::array<double, circumcenter_batch_size>, 4>;
  alignas(64) std::array<Batch, max_block_cells / circumcenter_batch_size> lengths;

  // Of corner j of cell k.
  double at(std::size_t k, std::size_t j) const {
    return lengths[k / circumcenter_batch_size][j][k % circumcenter_batch_size];
  }
};

// Of each arm the squared length, rounded, and the cell, so that a longer one has the larger word
// wherever the roundings differ.
struct ArmWords {
  using Batch = std::array<std::array<std::uint64_t, circumcenter_batch_size>, 4>;
  alignas(64) std::array<Batch, max_block_cells / circumcenter_batch_size> words;

  // Of corner j of cell k.
  std::uint64_t at(std::size_t k, std::size_t j) const {
    return words[k / circumcenter_batch_size][j][k % circumcenter_batch_size];
  }
};

// And how they lie to the normals of their corners. One bit per corner.
struct ArmSides {
  SquaredArms lower;  // of those below the tangent planes, arm . normal < 0, if not unsafe; else 0
  // In the lower nappe of the double cone (double_cone.h), and 16 times in the upper one.
  std::array<std::uint8_t, max_block_cells> nappes;
  // Not between the safe lengths of double_cone.h: nothing above is to be trusted.
  std::array<std::uint8_t, max_block_cells> unsafe;
};

// The bits of float(squared_norm(center - point)), plus 1, in the upper half: in the order of these
// floats, from 1 to 2^31 - 1. In the lower half the cells first, first + 1, ... of the block.
// Complexity: O(cells).
void arm_words(CellId first, const CellBlock& block, ArmWords& words);

// The sides, as dot() and cone_side() tell them; of the block of cells first, first + 1, ...
void arm_sides(const Triangulation& triangulation, const IdVector<VertexId, Vec3>& normals,
               double squared_cosine, CellId first, const CellBlock& block, ArmSides& arms);

}  // namespace cocoon
