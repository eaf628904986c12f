#include "delaunay/voronoi/cell_blocks.h"

#include <algorithm>
#include <bit>

#include "delaunay/voronoi/block_lanes.h"

namespace cocoon {

namespace {

void set_center(CellBlock& block, std::size_t k, const Point& center) {
  BatchOfPoints& centers = block.batches[k / circumcenter_batch_size].centers;
  const std::size_t lane = k % circumcenter_batch_size;
  centers[0][lane] = center.x;
  centers[1][lane] = center.y;
  centers[2][lane] = center.z;
}

// Fills in the centers that are not certified: otherwise(k) of cell k of the block.
template <class Otherwise>
void complete_centers(CellBlock& block, Otherwise otherwise) {
  for (std::size_t first = 0; first < block.size; first += circumcenter_batch_size) {
    const std::size_t size = std::min(circumcenter_batch_size, block.size - first);
    const unsigned all = (1U << size) - 1U;
    for (unsigned rest = all & ~block.batches[first / circumcenter_batch_size].certified; rest != 0;
         rest &= rest - 1) {
      const std::size_t k = first + static_cast<std::size_t>(std::countr_zero(rest));
      set_center(block, k, otherwise(k));
    }
  }
}

void compute_centers(CellBlock& block) {
  circumcenters_in_doubles(std::span(block.batches).first(block.used().size()));
}

}  // namespace

void load_run(const Triangulation& triangulation, const Dual& dual, CellId first, std::size_t count,
              CellBlock& block, const ReadSoon& soon) {
  const auto cell_at = [first](std::size_t k) { return CellId(first.index() + k); };
  if (dual.is_lean()) {
    load_centers(triangulation, first, count, soon, block);
    complete_centers(block,
                     [&](std::size_t k) { return hard_center(triangulation, dual, cell_at(k)); });
    return;
  }
  load_corners(triangulation, first, count, block);
  for (std::size_t k = 0; k < count; ++k) set_center(block, k, dual.centers[cell_at(k)]);
}

void load_cells(const Triangulation& triangulation, const Dual& dual, std::span<const CellId> cells,
                CellBlock& block) {
  // They lie here and there in memory: all are asked for in advance.
  for (const CellId c : cells) {
    __builtin_prefetch(&triangulation.cell(c));
    if (!dual.is_lean()) __builtin_prefetch(&dual.centers[c]);
  }
  load_corners(triangulation, cells, block);
  if (dual.is_lean()) {
    compute_centers(block);
    complete_centers(block,
                     [&](std::size_t k) { return hard_center(triangulation, dual, cells[k]); });
    return;
  }
  for (std::size_t k = 0; k < cells.size(); ++k) set_center(block, k, dual.centers[cells[k]]);
}

void load_cells(const Triangulation& triangulation, std::span<const CellId> cells,
                CellBlock& block) {
  load_corners(triangulation, cells, block);
  compute_centers(block);
  complete_centers(block,
                   [&](std::size_t k) { return circumcenter_of(triangulation, cells[k]).center; });
}

void load_new_run(const Triangulation& triangulation, CellId first, std::size_t count,
                  CellBlock& block, HardCenters& hard, const ReadSoon& soon) {
  load_centers(triangulation, first, count, soon, block);
  complete_centers(block, [&](std::size_t k) {
    const CellId c(first.index() + k);
    const Circumcenter found = circumcenter_of(triangulation, c);
    hard.note(found.level, c);
    if (found.level != CenterLevel::doubles) hard.centers.push_back(found.center);
    return found.center;
  });
}

}  // namespace cocoon
