// Lists of vertices that a caller makes.
#pragma once

#include <cstddef>
#include <span>

#include "geom/ids.h"

namespace cocoon {

// Throws InputError, one line, if the vertices are not strictly ascending, or not all of the first
// `count`. `stage`: whose input they are; `what`: what they are, in the plural.
// Complexity: O(vertices).
void require_ascending(const char* stage, const char* what, std::span<const VertexId> vertices,
                       std::size_t count);

}  // namespace cocoon
