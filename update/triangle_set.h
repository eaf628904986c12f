// Sets of triangles of one mesh as flags.
#pragma once

#include <cstdint>

#include "geom/id_vector.h"
#include "geom/ids.h"

namespace cocoon {

// One flag per triangle.
using TriangleSet = IdVector<TriangleId, std::uint8_t>;

}  // namespace cocoon
