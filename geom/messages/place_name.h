// A point, as messages say it.
#pragma once

#include <string>

#include "geom/point.h"

namespace cocoon {

// "(1.5, -2, 0.333333)": six digits of each coordinate, enough to find the place, and of large ones
// up to 1e14 three digits behind the point ("5403780.225").
std::string place_name(const Point& at);

}  // namespace cocoon
