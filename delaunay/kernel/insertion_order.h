// The order in which a batch of points is inserted.
#pragma once

#include <cstdint>
#include <vector>

#include "geom/point.h"

namespace cocoon {

// Positions in `points` in insertion rounds along the Hilbert curve (geom/spatial_order.h). A few
// points are left as they come: sorting them costs more than it saves.
// Precondition: all coordinates finite. Complexity: O(n). Deterministic.
std::vector<std::uint32_t> insertion_order(Points points);

}  // namespace cocoon
