// The sides of cells by a minimum cut (clean_up_cells.h, step 1).
#pragma once

#include <cstdint>
#include <vector>

#include "cocone/energy/ball_cosines.h"
#include "cocone/energy/cell_energy.h"
#include "delaunay/triangulation.h"
#include "geom/id_vector.h"

namespace cocoon {

// For each of these finite cells, none of them flat: 1 = OUT. Facet costs and preferences of cells
// are least in sum; of several such labelings the one with most IN cells. All other cells but flat
// ones have the side of their label. Flat cells are looked through: what meets through them is
// joined, each of their facets counting half. Complexity: that of MaxFlow for so many nodes.
std::vector<std::uint8_t> cut_cells(const Triangulation& triangulation, BallCosines& cosines,
                                    CellEnergy& energy, const IdVector<CellId, CellLabel>& labels,
                                    const std::vector<CellId>& cells);

}  // namespace cocoon
