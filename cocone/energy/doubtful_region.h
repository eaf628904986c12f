// The part of a triangulation that the clean-up looks at: around vertices that are not good.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "cocone/cell_marks.h"
#include "cocone/samples/sample_spacing.h"
#include "delaunay/star_cache.h"
#include "delaunay/triangulation.h"
#include "geom/arrays/zeroed_array.h"
#include "geom/execution.h"

namespace cocoon {

struct DoubtfulRegion {
  std::vector<VertexId> vertices;  // where something may be wrong, by SpacingCache::precedes
  ZeroedArray<VertexId, std::uint32_t> rank;  // 1 + position in `vertices`; 0: not among them
  std::vector<CellId> cells;                  // at these vertices, infinite ones too; increasing
  std::vector<CellId> undecided;  // poor cells but for those left, and thin ones; increasing
  std::size_t thin_cells = 0;     // among them
  VertexSet left;                 // 1: all poor cells at it are left alone; empty if none is
  std::size_t left_cells = 0;     // poor ones in clumps that are too large

  bool contains(VertexId v) const { return v != infinite_vertex && rank[v] != 0; }
  bool is_left(VertexId v) const { return left_cells != 0 && v != infinite_vertex && left[v] != 0; }
};

// Vertices that are not good, those contradicted where marks conflict, and those of undecided
// cells. Poor cells, finite ones without a good vertex, are undecided; those that hang together by
// facets are a clump. Clumps of more than `most_cells` cells are left alone, with the vertices that
// no other poor cell has. Thin cells, with good vertices, but at most `thin_support`, are
// undecided, too, at contradicted vertices and where they hang together with undecided cells by
// facets, unless they have a vertex that is left. `stars`, `spacings`: of this triangulation.
// Complexity: O(vertices + d log d) for d such vertices with their stars, besides what the first
// question to `stars` costs, and passes over the cells in the order of memory if they are many.
DoubtfulRegion find_doubtful_region(const Triangulation& triangulation, const CellMarks& marks,
                                    StarCache& stars, SpacingCache& spacings,
                                    std::size_t most_cells, int thin_support,
                                    const Execution& execution = {});

// Takes further vertices into the region, each with its cells. Complexity: O(region + k log k) for
// k of them, with their stars.
void extend_region(StarCache& stars, SpacingCache& spacings, std::span<const VertexId> vertices,
                   DoubtfulRegion& region);

// Is a vertex of the cell left alone? O(1).
bool has_left_vertex(const Triangulation& triangulation, const DoubtfulRegion& region, CellId c);

}  // namespace cocoon
