// The vertices of some cells.
#pragma once

#include <span>
#include <vector>

#include "delaunay/triangulation.h"

namespace cocoon {

// The finite ones, each once, as they come. Complexity: O(cells), and a pass over the vertices'
// memory.
std::vector<VertexId> vertices_of(const Triangulation& triangulation,
                                  std::span<const CellId> cells);

}  // namespace cocoon
