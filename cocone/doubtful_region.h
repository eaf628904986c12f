// The part of a triangulation that the clean-up looks at: around vertices that are not good.
#pragma once

#include <cstdint>
#include <vector>

#include "cocone/mark_cells.h"
#include "delaunay/triangulation.h"
#include "geom/zeroed_array.h"

namespace cocoon {

struct DoubtfulRegion {
  std::vector<VertexId> vertices;  // where something may be wrong, in lexicographic order
  ZeroedArray<VertexId, std::uint32_t> rank;  // 1 + position in `vertices`; 0: not among them
  std::vector<CellId> cells;                  // at these vertices, infinite ones too; increasing
  std::vector<CellId> undecided;              // finite cells without a good vertex; increasing

  bool contains(VertexId v) const { return v != infinite_vertex && rank[v] != 0; }
};

// Vertices that are not good; all of them if marks conflict. Complexity: O(cells + d log d) for d
// such vertices: one pass over the cells, in the order of memory.
DoubtfulRegion find_doubtful_region(const Triangulation& triangulation, const CellMarks& marks);

}  // namespace cocoon
