// Means over the surroundings of a vertex of the model.
#pragma once

#include <cstddef>

#include "update/model/model_index.h"

namespace cocoon {

// The mean of value(other) over the other corners of the triangles at v, which has some: each
// neighbor counts as often as it shares a triangle. In the order of ids, so that the sum does not
// depend on how the index knows them. Complexity: O(triangles at v).
template <class Value>
double mean_at_vertex(const ModelIndex& model, VertexId v, const Value& value) {
  double sum = 0;
  std::size_t count = 0;
  for (const TriangleId t : model.triangles_at(v)) {
    const Triangle& corners = model.mesh().triangles[t];
    for (std::size_t i = 0; i < 3; ++i) {
      if (corners[i] != v) continue;
      sum += value(corners[(i + 1) % 3]) + value(corners[(i + 2) % 3]);
      count += 2;
    }
  }
  return sum / static_cast<double>(count);
}

}  // namespace cocoon
