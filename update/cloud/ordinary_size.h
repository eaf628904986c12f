// Which lengths an update can measure.
#pragma once

#include <span>
#include <vector>

#include "geom/point.h"

namespace cocoon {

// Throws InputError, one line that names it, if a coordinate of a cloud is not finite; if most of a
// cloud's points are so much smaller than its largest that no scale holds both
// (require_comparable_sizes); or if the largest coordinate of the model or of a cloud is neither 0
// nor in [2^-200, 2^200]: the stages multiply three lengths and more, so they need room on both
// sides. (What is not finite in the model is for ModelIndex to name.) Complexity: O(n).
void require_ordinary_size(Points model, std::span<const std::vector<Point>> clouds);

}  // namespace cocoon
