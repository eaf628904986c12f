// The growing triangulation inside the kernel: cell records, marks, and slots to be used again.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "delaunay/renumbering.h"
#include "delaunay/triangulation.h"
#include "geom/execution.h"
#include "geom/id_vector.h"

namespace cocoon {

// Whether the search for the conflict zone of the current point has found a cell. The search
// computes with these numbers.
enum class CellMark : std::uint8_t { untested = 0, conflict = 1 };

template <>
struct ElementStorage<CellMark> {
  using type = std::vector<CellMark, OverwriteAllocator<CellMark>>;
};

// Invariant between insertions: cells that are not on the free list form a Delaunay triangulation
// with infinite cells (layout of triangulation.h, infinite cells anywhere), all marks are
// `untested`; a free cell has vertices[0] none.
struct CellPool {
  IdVector<CellId, Cell> cells;
  IdVector<CellId, CellMark> marks;
  std::vector<CellId> free;

  bool is_infinite(CellId c) const { return cells[c].vertices[3] == infinite_vertex; }
  bool is_free(CellId c) const { return cells[c].vertices[0].is_none(); }
};

// Errors: InputError if there are more cells than max_cells.
void require_cell_numbers(std::size_t count);

// Names places for `count` new cells: first `own`, those of the cells that go, then free ones, from
// the end of their list on, then new ones. What is left of `own` becomes free, the first of it
// last. `free`: the list that is used (of the pool, or of a thread); `places` is overwritten.
// Errors: as require_cell_numbers, and nothing is changed then. Complexity: O(count + own),
// amortized.
void take_places(CellPool& pool, std::vector<CellId>& free, std::span<const CellId> own,
                 std::size_t count, std::vector<CellId>& places);

// Drops the free cells and moves the infinite ones behind the finite ones. Cells on the right side
// already keep their numbers. Returns the number of finite cells. Complexity: O(cells) to look at
// them and O(moved cells), on thread_count(execution) threads; O(free + infinite cells) of memory.
// `done`, if given, gets what was done: one exchange after the other, then the end cut off.
std::size_t compact_cells(CellPool& pool, const Execution& execution = {},
                          std::vector<CellExchange>* done = nullptr);

}  // namespace cocoon
