#include "geom/messages/place_name.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace cocoon {

namespace {

int digits_of(double value) {
  constexpr int fewest = 6;
  constexpr int behind_point = 3;
  const double size = std::abs(value);
  if (!(size >= 1 && size < 1e14)) return fewest;
  return std::max(static_cast<int>(std::log10(size)) + 1 + behind_point, fewest);
}

}  // namespace

std::string place_name(const Point& at) {
  char text[96];
  std::snprintf(text, sizeof text, "(%.*g, %.*g, %.*g)", digits_of(at.x), at.x, digits_of(at.y),
                at.y, digits_of(at.z), at.z);
  return text;
}

}  // namespace cocoon
