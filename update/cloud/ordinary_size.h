// Which lengths an update can measure.
#pragma once

#include <span>
#include <vector>

#include "geom/point.h"

namespace cocoon {

// Throws InputError, one line that names it, if the largest coordinate of the model or of a cloud
// is not in [2^-200, 2^200] (nor 0, nor not finite: that is for delaunay() to name): the stages
// multiply three lengths and more, so they need room on both sides. Complexity: O(n).
void require_ordinary_size(Points model, std::span<const std::vector<Point>> clouds);

}  // namespace cocoon
