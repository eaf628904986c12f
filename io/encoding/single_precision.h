// Rounding to float where a format or its reader wants that.
#pragma once

#include <cmath>
#include <limits>

namespace cocoon {

// The nearest float; false if the value is beyond the largest one (a cast would then be undefined).
inline bool round_to_float(double value, float& rounded) {
  if (!(std::abs(value) <= static_cast<double>(std::numeric_limits<float>::max()))) return false;
  rounded = static_cast<float>(value);
  return true;
}

}  // namespace cocoon
