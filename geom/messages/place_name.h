// A point, as messages say it.
#pragma once

#include <cstdio>
#include <string>

#include "geom/point.h"

namespace cocoon {

// "(1.5, -2, 0.333333)": six digits of each coordinate, enough to find the place.
inline std::string place_name(const Point& at) {
  char text[64];
  std::snprintf(text, sizeof text, "(%.6g, %.6g, %.6g)", at.x, at.y, at.z);
  return text;
}

}  // namespace cocoon
