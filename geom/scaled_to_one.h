// Vectors of any length, brought to where squares and products stay in the range of double.
#pragma once

#include <cmath>

#include "geom/point.h"

namespace cocoon {

// v times the power of two that brings its largest coordinate to [1, 2): exact but for coordinates
// 2^1000 times smaller. The zero vector and vectors that are not finite stay. O(1).
inline Vec3 scaled_to_one(const Vec3& v) {
  const double reach = max_norm(v);
  if (!(reach > 0) || !std::isfinite(reach)) return v;
  const int exponent = -std::ilogb(reach);
  const double power = std::ldexp(1.0, exponent);
  if (std::isfinite(power)) return power * v;  // one call, and the same numbers
  return {std::ldexp(v.x, exponent), std::ldexp(v.y, exponent), std::ldexp(v.z, exponent)};
}

}  // namespace cocoon
