// Edges of a model that do not have two triangles.
#pragma once

#include <cstdint>
#include <vector>

#include "geom/ids.h"
#include "update/model/model_index.h"

namespace cocoon {

// One triangle's share in the edge between two vertices. All of an edge are equal.
struct EdgeSide {
  VertexId low;  // the smaller one
  VertexId high;

  friend auto operator<=>(const EdgeSide&, const EdgeSide&) = default;
};

// The sides along edges that have one triangle, or more than two; increasing. Triangles that repeat
// a vertex have none. Complexity: O(1) for a mesh that is known to be smooth
// (ModelIndex::of_smooth()), else O(t), and sorting what is found.
std::vector<EdgeSide> irregular_sides(const ModelIndex& model);

}  // namespace cocoon
