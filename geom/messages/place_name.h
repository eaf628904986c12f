// A point, as messages say it.
#pragma once

#include <string>

#include "geom/point.h"

namespace cocoon {

// "(1.5, -2, 0.333333)": six digits of each coordinate, enough to find the place, and of large ones
// three digits behind the point ("5403780.225") where a double has them.
std::string place_name(const Point& at);

}  // namespace cocoon
