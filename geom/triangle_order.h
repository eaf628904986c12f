// The canonical order of triangles: each with its smallest vertex first, then lexicographic.
#pragma once

#include "geom/ids.h"
#include "geom/triangle_mesh.h"

namespace cocoon {

// Not above any triangle. (An id that is not set is `none`, above all others.)
constexpr Triangle lowest_triangle = {VertexId(0), VertexId(0), VertexId(0)};

// The same triangle with the same orientation, whatever vertex came first; of equal vertices the
// earlier one counts as smaller. Complexity: O(1).
constexpr Triangle smallest_first(const Triangle& t) {
  if (t[0] <= t[1] && t[0] <= t[2]) return t;
  return t[1] <= t[2] ? Triangle{t[1], t[2], t[0]} : Triangle{t[2], t[0], t[1]};
}

}  // namespace cocoon
