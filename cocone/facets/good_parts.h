// Which good vertices hang together by edges of a surface.
#pragma once

#include <array>
#include <cstddef>

#include "geom/arrays/disjoint_sets.h"
#include "geom/ids.h"

namespace cocoon {

// Joins those of a triangle's three corners for which is_good(corner) holds; returns how many parts
// there are fewer for that. O(1) amortized.
template <class IsGood>
std::size_t join_good(DisjointSets& parts, const Triangle& corners, IsGood is_good) {
  const auto join = [&](VertexId a, VertexId b) -> std::size_t {
    return is_good(a) && is_good(b) && parts.join(a.value, b.value) ? 1 : 0;
  };
  const auto [a, b, c] = corners;
  const std::size_t fewer = join(a, b) + join(b, c);
  return is_good(b) ? fewer : fewer + join(c, a);  // else these two are joined already
}

}  // namespace cocoon
