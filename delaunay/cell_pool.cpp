#include "delaunay/cell_pool.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "geom/errors.h"

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

// The infinite cells in increasing order.
std::vector<CellId> infinite_cells(const CellPool& pool, const Execution& execution) {
  constexpr std::size_t grain = std::size_t{1} << 16;
  std::vector<std::vector<CellId>> found(pool.cells.size() / grain + 1);
  parallel_chunks(execution, pool.cells.size(), grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c) {
      if (pool.is_infinite(CellId(c))) found[begin / grain].push_back(CellId(c));
    }
  });
  std::vector<CellId> all;
  for (const std::vector<CellId>& part : found) all.insert(all.end(), part.begin(), part.end());
  return all;
}

}  // namespace

void require_cell_numbers(std::size_t count) {
  if (count <= max_cells) return;
  throw InputError("too many points: the triangulation needs more than " +
                   std::to_string(max_cells) + " tetrahedra, the most that can be numbered");
}

std::size_t compact_cells(CellPool& pool, const Execution& execution) {
  // Free cells to the end: fill each hole with the last live cell.
  std::sort(pool.free.begin(), pool.free.end());
  std::size_t live = pool.cells.size();
  for (const CellId hole : pool.free) {
    while (live > hole.index() && pool.is_free(CellId(live - 1))) --live;
    if (live <= hole.index()) break;
    swap_cells(pool, hole, CellId(--live));
  }
  pool.cells.resize(live);
  pool.marks.resize(live);
  pool.free.clear();

  // Infinite cells behind the finite ones: exchange the first infinite with the last finite one.
  const std::vector<CellId> infinite = infinite_cells(pool, execution);
  std::size_t back = live;
  for (const CellId front : infinite) {
    while (back > front.index() && pool.is_infinite(CellId(back - 1))) --back;
    if (back <= front.index()) break;
    swap_cells(pool, front, CellId(--back));
  }
  return live - infinite.size();
}

}  // namespace cocoon
