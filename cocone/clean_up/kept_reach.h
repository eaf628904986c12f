// Which cells infinity reaches, and whether it still does, told from where something has changed.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "delaunay/triangulation.h"
#include "geom/id_vector.h"
#include "geom/ids.h"

namespace cocoon {

// Whether every OUT cell (`out` is 1) is still connected to infinity through OUT cells, after the
// cells in `changed` (finite, each once) switched sides; before, every one was. Looks only at the
// OUT cells around each connected set of changed ones: if they are connected nearby, a way to
// infinity that led through the set can go around it. False may also mean that this was not found
// among `most_cells` cells for each set.
// Complexity: O(cells looked at). Source: ours, docs/stages/clean_up_cells.md.
bool is_reach_kept(const Triangulation& triangulation, const IdVector<CellId, std::uint8_t>& out,
                   std::span<const CellId> changed, std::size_t most_cells = 20000);

// 1 for each cell that infinity reaches through OUT cells (`out` is 1), itself included; else 0.
// Complexity: O(cells).
IdVector<CellId, std::uint8_t> reached_from_infinity(const Triangulation& triangulation,
                                                     const IdVector<CellId, std::uint8_t>& out);

// Adds the cells that one of `cells` reaches, these included. Complexity: O(cells added).
void extend_reach(const Triangulation& triangulation, const IdVector<CellId, std::uint8_t>& out,
                  std::vector<CellId> cells, IdVector<CellId, std::uint8_t>& reached);

}  // namespace cocoon
