#include "delaunay/vertex_stars.h"

namespace cocoon {

VertexStars vertex_stars(const Triangulation& triangulation) {
  // Counting sort of the corners by vertex. Cells are visited in increasing order both times, so
  // every star comes out sorted.
  const std::size_t num_vertices = triangulation.num_vertices();
  std::vector<std::uint32_t> offsets(num_vertices + 1, 0);
  for (const Cell& cell : triangulation.cell_records()) {
    for (const VertexId v : cell.vertices) {
      if (v != infinite_vertex) ++offsets[v.index() + 1];
    }
  }
  for (std::size_t v = 0; v < num_vertices; ++v) offsets[v + 1] += offsets[v];

  std::vector<CellId> cells(offsets.back());
  std::vector<std::uint32_t> next(offsets.begin(), offsets.end() - 1);
  for (const CellId c : triangulation.cells()) {
    for (const VertexId v : triangulation.cell(c).vertices) {
      if (v != infinite_vertex) cells[next[v.index()]++] = c;
    }
  }
  return VertexStars(std::move(offsets), std::move(cells));
}

}  // namespace cocoon
