#include "cocone/samples/cone_sides.h"

#include <algorithm>
#include <array>

#include "cocone/samples/double_cone.h"

namespace cocoon {
namespace {

constexpr std::size_t cells_per_chunk = 4096;

// One bit per vertex of a cell in the order of their ids: [ranks][bits].
using BitsByRank = std::array<std::array<std::uint8_t, 16>, 256>;

constexpr BitsByRank make_bits_by_rank() {
  BitsByRank by_rank{};
  for (unsigned ranks = 0; ranks < 256; ++ranks) {
    for (unsigned bits = 0; bits < 16; ++bits) {
      unsigned ordered = 0;
      for (unsigned j = 0; j < 4; ++j) ordered |= (bits >> j & 1U) << (ranks >> 2 * j & 3U);
      by_rank[ranks][bits] = static_cast<std::uint8_t>(ordered);
    }
  }
  return by_rank;
}

constexpr BitsByRank bits_by_rank = make_bits_by_rank();

// `nappes`: bit j = in the lower nappe of vertex j of the cell, bit 4 + j = in the upper one.
CornerSides in_order(const Cell& cell, unsigned nappes) {
  const std::uint8_t ranks = vertex_ranks(cell);
  const auto& by_rank = bits_by_rank[ranks];
  return {static_cast<std::uint8_t>(by_rank[nappes & 15U] | by_rank[nappes >> 4] << 4), ranks};
}

// Of one cell, of any size.
CornerSides cone_sides_of_cell(const Triangulation& triangulation, const Dual& dual,
                               const IdVector<VertexId, Vec3>& normals, double squared_cosine,
                               CellId c) {
  const Point center = center_of(triangulation, dual, c);
  const bool is_ray = triangulation.is_infinite(c);
  unsigned nappes = 0;
  for (int j = 0; j < (is_ray ? 3 : 4); ++j) {
    const VertexId v = triangulation.vertex(c, j);
    const Vec3 x = is_ray ? center : center - triangulation.point(v);
    const ConeSide side = cone_side(x, normals[v], squared_cosine);
    nappes |= static_cast<unsigned>(side == ConeSide::below) << j;
    nappes |= static_cast<unsigned>(side == ConeSide::above) << (4 + j);
  }
  return in_order(triangulation.cell(c), nappes);
}

}  // namespace

void take_cone_sides(const Triangulation& triangulation, const Dual& dual,
                     const IdVector<VertexId, Vec3>& normals, const ArmSides& arms, CellId first,
                     std::size_t count, ConeSides& sides) {
  for (std::size_t k = 0; k < count; ++k) {
    const CellId c(first.index() + k);
    sides.of_cells[c] = in_order(triangulation.cell(c), arms.nappes[k]);
  }
  for (std::size_t k = 0; k < count; ++k) {
    if (arms.unsafe[k] == 0) continue;
    const CellId c(first.index() + k);
    sides.of_cells[c] =
        cone_sides_of_cell(triangulation, dual, normals, sides.cosine * sides.cosine, c);
  }
}

void take_ray_sides(const Triangulation& triangulation, const Dual& dual,
                    const IdVector<VertexId, Vec3>& normals, ConeSides& sides,
                    const Execution& execution) {
  const double squared_cosine = sides.cosine * sides.cosine;
  const std::size_t finite = triangulation.num_finite_cells();
  parallel_chunks(execution, triangulation.num_cells() - finite, cells_per_chunk,
                  [&](std::size_t begin, std::size_t end) {
                    for (CellId c(finite + begin); c.index() < finite + end; ++c) {
                      sides.of_cells[c] =
                          cone_sides_of_cell(triangulation, dual, normals, squared_cosine, c);
                    }
                  });
}

ConeSides cone_sides(const Triangulation& triangulation, const Dual& dual,
                     const IdVector<VertexId, Vec3>& normals, double cosine,
                     const Execution& execution) {
  ConeSides sides{cosine, IdVector<CellId, CornerSides>(triangulation.num_cells())};
  const double squared_cosine = cosine * cosine;
  parallel_chunks(execution, triangulation.num_finite_cells(), cells_per_chunk,
                  [&](std::size_t begin, std::size_t end) {
                    CellBlock block;
                    ArmSides arms;
                    for (std::size_t first = begin; first < end; first += max_block_cells) {
                      const std::size_t count = std::min(max_block_cells, end - first);
                      load_run(triangulation, dual, CellId(first), count, block);
                      arm_sides(triangulation, normals, squared_cosine, CellId(first), block, arms);
                      take_cone_sides(triangulation, dual, normals, arms, CellId(first), count,
                                      sides);
                    }
                  });
  take_ray_sides(triangulation, dual, normals, sides, execution);
  return sides;
}

}  // namespace cocoon
