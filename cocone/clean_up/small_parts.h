// Small parts of a body of cells.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "delaunay/triangulation.h"
#include "geom/id_vector.h"

namespace cocoon {

// Parts of the body, finite cells with out = 0 that hang together by facets: those that have one of
// these cells and at most `most_cells`, the smallest first, ties by cell_order.h. But not the
// largest part of the body (of equals, the last); a part elsewhere counts as one with all others.
// Complexity: O(cells at hand): each is looked at once, and of a large part not many more than
// `most_cells` but for the given ones; one pass over `out` where no part is large.
std::vector<std::vector<CellId>> small_parts(const Triangulation& triangulation,
                                             const IdVector<CellId, std::uint8_t>& out,
                                             std::span<const CellId> at, std::size_t most_cells);

}  // namespace cocoon
