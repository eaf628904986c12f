// Which of a list of points are equal.
#pragma once

#include <cstdint>
#include <vector>

#include "geom/point.h"

namespace cocoon {

// For each point the position of the first one that is equal to it (0 and -0 are): its own, if it
// has no equal before. Precondition: finite points, fewer than 2^32.
// Complexity: O(n), two passes over the points, and k log k for k points that are equal or look so
// to a hash of 16 bits per point (about n / 8). Deterministic.
std::vector<std::uint32_t> first_of_equal(Points points);

// The same for points of which the first `distinct` are known to differ from each other: the hashes
// are those of the others.
std::vector<std::uint32_t> first_of_equal(Points points, std::size_t distinct);

}  // namespace cocoon
