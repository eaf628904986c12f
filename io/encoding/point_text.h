// Points as text.
#pragma once

#include <string>

#include "geom/point.h"
#include "io/encoding/number_text.h"

namespace cocoon {

// Appends "x y z", or with another separator, with all bits of the coordinates (number_text.h).
inline void append_point(std::string& text, const Point& p, char separator = ' ') {
  append_number(text, p.x);
  text += separator;
  append_number(text, p.y);
  text += separator;
  append_number(text, p.z);
}

}  // namespace cocoon
