// The canonical order of triangles: each with its smallest vertex first, then lexicographic.
#pragma once

#include <cstdint>

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

// a < b, by two words: a loop over the corners costs as much as all else where millions of
// triangles are merged.
constexpr bool precedes(const Triangle& a, const Triangle& b) {
  const auto edge = [](const Triangle& t) { return std::uint64_t{t[0].value} << 32 | t[1].value; };
  return edge(a) != edge(b) ? edge(a) < edge(b) : a[2] < b[2];
}

}  // namespace cocoon
