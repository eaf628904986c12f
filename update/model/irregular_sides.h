// Edges of a model that do not have two triangles.
#pragma once

#include <cstdint>
#include <vector>

#include "geom/ids.h"
#include "update/model/model_index.h"

namespace cocoon {

// Of a triangle along an edge. In the order of edges, and so those of one edge follow each other.
struct Side {
  VertexId low;
  VertexId high;

  friend auto operator<=>(const Side&, const Side&) = default;
};

// The sides along edges that have one triangle, or more than two; increasing. Triangles that repeat
// a vertex have none. Complexity: O(1) for a mesh that is known to be smooth
// (ModelIndex::of_smooth()), else O(t), and sorting them.
std::vector<Side> irregular_sides(const ModelIndex& model);

}  // namespace cocoon
