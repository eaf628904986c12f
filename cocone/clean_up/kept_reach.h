// Whether cells that infinity could reach still can, told from where something has changed.
#pragma once

#include <cstdint>
#include <span>

#include "delaunay/triangulation.h"
#include "geom/id_vector.h"
#include "geom/ids.h"

namespace cocoon {

// `out`: 1 = a cell is OUT; `changed`: those that have another side than before, each once, all
// finite. Before, each OUT cell hung together with the infinite ones by facets between OUT cells.
// True if that is so now: a way to infinity that led through changed cells can take another one
// around them, since the OUT cells at each connected set of changed ones hang together nearby.
// False if some do not, or if that is not seen among `most_cells` cells for each set.
// Complexity: O(cells looked at). Source: ours, docs/stages/clean_up_cells.md.
bool is_reach_kept(const Triangulation& triangulation, const IdVector<CellId, std::uint8_t>& out,
                   std::span<const CellId> changed, std::size_t most_cells = 20000);

// 1 for each cell that infinity reaches through OUT cells (`out` is 1), itself included; else 0.
// Complexity: O(cells).
IdVector<CellId, std::uint8_t> reached_from_infinity(const Triangulation& triangulation,
                                                     const IdVector<CellId, std::uint8_t>& out);

}  // namespace cocoon
