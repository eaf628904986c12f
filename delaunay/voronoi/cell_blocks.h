// Finite cells with their corners and Voronoi vertices in the lanes of vector instructions, a few
// at a time, for stages that go over many.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "delaunay/triangulation.h"
#include "delaunay/voronoi/lean_dual.h"
#include "delaunay/voronoi_dual.h"
#include "geom/circumsphere_batch.h"
#include "geom/point.h"

namespace cocoon {

// As many batches of geom/circumsphere_batch.h as it takes. What is behind the last cell means
// nothing.
inline constexpr std::size_t max_block_cells = 128;
struct CellBlock {
  std::array<CircumcenterBatch, max_block_cells / circumcenter_batch_size> batches;
  std::size_t size = 0;  // cells

  std::span<const CircumcenterBatch> used() const {
    return std::span(batches).first((size + circumcenter_batch_size - 1) / circumcenter_batch_size);
  }
  Point center(std::size_t k) const {
    const BatchOfPoints& centers = batches[k / circumcenter_batch_size].centers;
    const std::size_t lane = k % circumcenter_batch_size;
    return {centers[0][lane], centers[1][lane], centers[2][lane]};
  }
};

// Per-vertex arrays that the caller reads while it works on a block, if any. Callers that go over
// consecutive runs name them, so that their elements are prefetched one run ahead.
struct ReadSoon {
  const Vec3* vectors = nullptr;  // not without the other
  const void* words = nullptr;    // of 8 bytes
};

// Fills in the block: with the cells first, first + 1, ..., or with cells anywhere. Of a run the
// points of the next one are prefetched.
// Preconditions: finite cells, at most max_block_cells. Complexity: O(cells).
void load_run(const Triangulation& triangulation, const Dual& dual, CellId first, std::size_t count,
              CellBlock& block, const ReadSoon& soon = {});
void load_cells(const Triangulation& triangulation, const Dual& dual, std::span<const CellId> cells,
                CellBlock& block);
// The same without a dual, for stages that look at few of all cells.
void load_cells(const Triangulation& triangulation, std::span<const CellId> cells,
                CellBlock& block);
// As load_run, without a dual.
void load_new_run(const Triangulation& triangulation, CellId first, std::size_t count,
                  CellBlock& block, HardCenters& hard, const ReadSoon& soon = {});

// Calls visit(cells, their block) for the finite ones of some cells, a few at a time, in their
// order. Complexity: O(cells).
template <class Visit>
void for_each_block(const Triangulation& triangulation, std::span<const CellId> cells,
                    Visit visit) {
  CellBlock block;
  std::array<CellId, max_block_cells> finite;
  for (std::size_t next = 0; next < cells.size();) {
    std::size_t count = 0;
    for (; next < cells.size() && count < max_block_cells; ++next) {
      if (!triangulation.is_infinite(cells[next])) finite[count++] = cells[next];
    }
    if (count == 0) return;
    load_cells(triangulation, std::span(finite).first(count), block);
    visit(std::span<const CellId>(finite).first(count), block);
  }
}

}  // namespace cocoon
