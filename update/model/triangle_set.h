// Sets of triangles of one mesh as flags.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "geom/arrays/visit_where.h"
#include "geom/id_vector.h"
#include "geom/ids.h"

namespace cocoon {

// One flag per triangle.
using TriangleSet = IdVector<TriangleId, std::uint8_t>;

// Those whose flag is set, ascending. Complexity: O(triangles).
inline std::vector<TriangleId> members(const TriangleSet& set) {
  std::vector<TriangleId> found;
  const std::span<const std::uint8_t> flags = set.span();
  visit_where(
      flags.size(), [&](std::size_t i) { return flags[i] != 0; },
      [&](std::size_t i) { found.push_back(TriangleId(i)); });
  return found;
}

}  // namespace cocoon
