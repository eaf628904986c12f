#include "cocone/cone_sides.h"

#include <algorithm>

#include "cocone/double_cone.h"

namespace cocoon {
namespace {

constexpr std::size_t cells_per_chunk = 4096;

}  // namespace

CornerSides cone_sides_of_cell(const Triangulation& triangulation, const Dual& dual,
                               const IdVector<VertexId, Vec3>& normals, double squared_cosine,
                               CellId c) {
  const Point center = center_of(triangulation, dual, c);
  const bool is_ray = triangulation.is_infinite(c);
  unsigned sides = 0;
  for (int j = 0; j < (is_ray ? 3 : 4); ++j) {
    const VertexId v = triangulation.vertex(c, j);
    const Vec3 x = is_ray ? center : center - triangulation.point(v);
    const ConeSide side = cone_side(x, normals[v], squared_cosine);
    sides |= static_cast<unsigned>(side == ConeSide::below) << j;
    sides |= static_cast<unsigned>(side == ConeSide::above) << (4 + j);
  }
  return static_cast<CornerSides>(sides);
}

ConeSides cone_sides(const Triangulation& triangulation, const Dual& dual,
                     const IdVector<VertexId, Vec3>& normals, double cosine,
                     const Execution& execution) {
  ConeSides sides{cosine, IdVector<CellId, CornerSides>(triangulation.num_cells())};
  const double squared_cosine = cosine * cosine;
  parallel_chunks(
      execution, triangulation.num_cells(), cells_per_chunk,
      [&](std::size_t begin, std::size_t end) {
        const std::size_t infinite = std::clamp(triangulation.num_finite_cells(), begin, end);
        CellBlock block;
        ArmSides arms;
        for (std::size_t first = begin; first < infinite; first += max_block_cells) {
          const std::size_t count = std::min(max_block_cells, infinite - first);
          load_run(triangulation, dual, CellId(first), count, block);
          arm_sides(triangulation, normals, squared_cosine, CellId(first), block, arms);
          take_cone_sides(triangulation, dual, normals, arms, CellId(first), count, sides);
        }
        for (CellId c(infinite); c.index() < end; ++c) {
          sides.of_cells[c] = cone_sides_of_cell(triangulation, dual, normals, squared_cosine, c);
        }
      });
  return sides;
}

}  // namespace cocoon
