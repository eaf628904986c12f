#include "geom/messages/place_name.h"

#include <algorithm>
#include <cmath>

#include "geom/messages/rounded.h"

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
  std::string name = "(";
  for (const double value : {at.x, at.y, at.z}) {
    if (name.size() > 1) name += ", ";
    name += rounded(value, digits_of(value));
  }
  name += ")";
  return name;
}

}  // namespace cocoon
