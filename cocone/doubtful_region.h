// The part of a triangulation that the clean-up looks at: around vertices that are not good.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "cocone/mark_cells.h"
#include "delaunay/star_cache.h"
#include "delaunay/triangulation.h"
#include "geom/zeroed_array.h"

namespace cocoon {

struct DoubtfulRegion {
  std::vector<VertexId> vertices;  // where something may be wrong, in lexicographic order
  ZeroedArray<VertexId, std::uint32_t> rank;  // 1 + position in `vertices`; 0: not among them
  std::vector<CellId> cells;                  // at these vertices, infinite ones too; increasing
  std::vector<CellId> undecided;  // finite cells without a good vertex; increasing; not those left
  VertexSet left;                 // 1: all undecided cells at it are left alone; empty if none is
  std::size_t left_cells = 0;     // undecided ones in clumps that are too large

  bool contains(VertexId v) const { return v != infinite_vertex && rank[v] != 0; }
  bool is_left(VertexId v) const { return left_cells != 0 && v != infinite_vertex && left[v] != 0; }
};

// Vertices that are not good, and those contradicted where marks conflict. Undecided cells that
// hang together by facets are a clump. Those of more than `most_cells` cells are left alone, with
// the vertices that no other undecided cell has. `stars`: of this triangulation. Complexity:
// O(vertices + d log d) for d such vertices with their stars, besides what the first question to
// `stars` costs, and passes over the cells in the order of memory if they are many.
DoubtfulRegion find_doubtful_region(
    const Triangulation& triangulation, const CellMarks& marks, StarCache& stars,
    std::size_t most_cells = std::numeric_limits<std::size_t>::max());

// Takes further vertices into the region, each with its cells. Complexity: O(region + k log k) for
// k of them, with their stars.
void extend_region(const Triangulation& triangulation, StarCache& stars,
                   std::span<const VertexId> vertices, DoubtfulRegion& region);

// Is the cell undecided, and in a clump that was left to the peel? Complexity: O(log cells).
bool is_left(const Triangulation& triangulation, const CellMarks& marks,
             const DoubtfulRegion& region, CellId c);

}  // namespace cocoon
