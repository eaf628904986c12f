// Hashes of points.
#pragma once

#include <bit>
#include <cstdint>

#include "geom/point.h"
#include "geom/random/mixed_bits.h"

namespace cocoon {

// The same for equal points: 0 and -0 are. Precondition: finite coordinates. O(1).
inline std::uint64_t point_hash(const Point& p) {
  const auto bits = [](double x) { return std::bit_cast<std::uint64_t>(x + 0.0); };  // -0 is 0
  return mixed_bits(bits(p.x) + mixed_bits(bits(p.y) + mixed_bits(bits(p.z))));
}

}  // namespace cocoon
