#include "ref/cell_set.h"

#include <algorithm>

#include "geom/random/random.h"

namespace cocoon::ref {
namespace {

std::array<PointId, 4> points_of_cell(const Triangulation& triangulation, CellId c) {
  std::array<PointId, 4> result;
  for (int i = 0; i < 4; ++i) {
    result[static_cast<std::size_t>(i)] = triangulation.point_of_vertex(triangulation.vertex(c, i));
  }
  std::sort(result.begin(), result.end());
  return result;
}

}  // namespace

std::vector<std::array<PointId, 4>> cell_set(const Triangulation& triangulation) {
  std::vector<std::array<PointId, 4>> cells;
  cells.reserve(triangulation.num_finite_cells());
  for (const CellId c : triangulation.finite_cells()) {
    cells.push_back(points_of_cell(triangulation, c));
  }
  std::sort(cells.begin(), cells.end());
  return cells;
}

std::uint64_t cell_set_hash(const Triangulation& triangulation) {
  std::uint64_t sum = 0;
  for (const CellId c : triangulation.finite_cells()) {
    sum += cell_hash(points_of_cell(triangulation, c));
  }
  return sum;
}

std::uint64_t cell_hash(std::array<PointId, 4> cell) {
  std::sort(cell.begin(), cell.end());
  std::uint64_t mixed = 0;
  for (const PointId p : cell) {
    std::uint64_t state = mixed ^ p.value;
    mixed = splitmix64(state);
  }
  return mixed;
}

}  // namespace cocoon::ref
