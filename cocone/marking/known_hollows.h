// Hollows of a body that labels which are known beforehand tell.
#pragma once

#include <cstdint>
#include <vector>

#include "cocone/marking/cell_label.h"
#include "delaunay/triangulation.h"
#include "geom/id_vector.h"
#include "geom/ids.h"

namespace cocoon {

// The finite cells known to be OUT that infinity does not reach (`reached` is 0) and that have a
// sample at which it reaches no cell. Elsewhere what is known to be OUT is a pocket of slivers
// beside the surface. Neither array is empty. Complexity: O(cells). Source: ours.
std::vector<CellId> known_hollow_cells(const Triangulation& triangulation,
                                       const IdVector<CellId, CellLabel>& known,
                                       const IdVector<CellId, std::uint8_t>& reached);

}  // namespace cocoon
