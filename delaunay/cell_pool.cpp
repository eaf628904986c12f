#include "delaunay/cell_pool.h"

#include <utility>

namespace cocoon {
namespace {

void point_neighbors_at(CellPool& pool, CellId c) {
  const Cell& cell = pool.cells[c];
  for (int i = 0; i < 4; ++i) {
    const FacetId behind = cell.neighbors[static_cast<std::size_t>(i)];
    pool.cells[cell_of(behind)].neighbors[static_cast<std::size_t>(index_of(behind))] =
        facet_id(c, i);
  }
}

// Swaps the records of two cells, which may be neighbors of each other; `b` must not be free.
void swap_cells(CellPool& pool, CellId a, CellId b) {
  const bool a_is_free = pool.is_free(a);
  std::swap(pool.cells[a], pool.cells[b]);
  // A neighbor relation between the two now names the wrong one of them on both sides.
  const auto exchange = [&](CellId c) {
    for (FacetId& neighbor : pool.cells[c].neighbors) {
      const CellId cell = cell_of(neighbor);
      if (cell == a) {
        neighbor = facet_id(b, index_of(neighbor));
      } else if (cell == b) {
        neighbor = facet_id(a, index_of(neighbor));
      }
    }
  };
  exchange(a);
  if (!a_is_free) exchange(b);
  point_neighbors_at(pool, a);
  if (!a_is_free) point_neighbors_at(pool, b);
}

}  // namespace

std::size_t compact_cells(CellPool& pool) {
  // Free cells to the end: fill each hole with the last live cell.
  std::size_t live = pool.cells.size();
  for (std::size_t c = 0; c < live; ++c) {
    if (!pool.is_free(CellId(c))) continue;
    do {
      --live;
    } while (live > c && pool.is_free(CellId(live)));
    if (live > c) swap_cells(pool, CellId(c), CellId(live));
  }
  pool.cells.resize(live);
  pool.marks.resize(live);
  pool.free.clear();

  // Infinite cells behind the finite ones: exchange the first infinite with the last finite one.
  std::size_t front = 0;
  std::size_t back = live;
  for (;;) {
    while (front < back && !pool.is_infinite(CellId(front))) ++front;
    while (front < back && pool.is_infinite(CellId(back - 1))) --back;
    if (front == back) return front;
    swap_cells(pool, CellId(front), CellId(back - 1));
  }
}

}  // namespace cocoon
