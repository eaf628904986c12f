// What points must be like so that they have a triangulation. Complexity: O(n) for require_finite,
// else O(1).
#pragma once

#include <cstddef>

#include "geom/execution.h"
#include "geom/point.h"

namespace cocoon {

// Errors: InputError if so many points cannot be numbered.
void require_ids(std::size_t points);

// Errors: InputError if a coordinate is not finite; names the first such point.
void require_finite(Points points, const Execution& execution = {});

// Errors: DegenerateInput if `count` different points of this affine dimension do not span space;
// says which of the ways.
void require_space(int dimension, std::size_t count);

}  // namespace cocoon
