#include "cocone/marking/known_hollows.h"

#include <algorithm>

namespace cocoon {

std::vector<CellId> known_hollow_cells(const Triangulation& triangulation,
                                       const IdVector<CellId, CellLabel>& known,
                                       const IdVector<CellId, std::uint8_t>& reached) {
  IdVector<VertexId, std::uint8_t> is_outside(triangulation.num_vertices(), 0);
  for (const CellId c : triangulation.finite_cells()) {
    if (reached[c] == 0) continue;
    for (const VertexId v : triangulation.cell(c).vertices) is_outside[v] = 1;
  }
  for (const CellId c : triangulation.infinite_cells()) {
    for (int i = 0; i < 3; ++i) is_outside[triangulation.vertex(c, i)] = 1;
  }
  std::vector<CellId> cells;
  for (const CellId c : triangulation.finite_cells()) {
    if (reached[c] != 0 || known[c] != CellLabel::out) continue;
    const auto& vertices = triangulation.cell(c).vertices;
    const bool is_inner = std::any_of(vertices.begin(), vertices.end(),
                                      [&](VertexId v) { return is_outside[v] == 0; });
    if (is_inner) cells.push_back(c);
  }
  return cells;
}

}  // namespace cocoon
