// The growing triangulation inside the kernel: cell records, marks, and slots to be used again.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "delaunay/triangulation.h"
#include "geom/id_vector.h"

namespace cocoon {

// What the search for the conflict zone of the current point knows about a cell.
enum class CellMark : std::uint8_t { untested = 0, conflict = 1, outside = 2 };

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

// FacetId packs a cell and a facet index into 32 bits.
inline constexpr std::size_t max_cells = std::size_t{1} << 30;

// Drops the free cells and moves the infinite ones behind the finite ones. Cells on the right side
// already keep their numbers. Returns the number of finite cells. Complexity: O(cells), constant
// extra memory.
std::size_t compact_cells(CellPool& pool);

}  // namespace cocoon
