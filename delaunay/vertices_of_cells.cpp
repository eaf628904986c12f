#include "delaunay/vertices_of_cells.h"

#include <cstdint>

#include "geom/arrays/zeroed_array.h"

namespace cocoon {

std::vector<VertexId> vertices_of(const Triangulation& triangulation,
                                  std::span<const CellId> cells) {
  std::vector<VertexId> vertices;
  ZeroedArray<VertexId, std::uint8_t> met(triangulation.num_vertices());
  for (const CellId c : cells) {
    for (const VertexId v : triangulation.cell(c).vertices) {
      if (v == infinite_vertex || met[v] != 0) continue;
      met[v] = 1;
      vertices.push_back(v);
    }
  }
  return vertices;
}

}  // namespace cocoon
