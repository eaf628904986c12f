#include "delaunay/vertex_stars.h"

namespace cocoon {

namespace {

// Of every star the cells that lie in a range.
VertexStars stars_in_range(const Triangulation& triangulation, IdRange<CellId> range) {
  // Counting sort of the corners by vertex. Cells are visited in increasing order both times, so
  // every star comes out sorted.
  const std::size_t num_vertices = triangulation.num_vertices();
  std::vector<std::uint32_t> offsets(num_vertices + 1, 0);
  for (const CellId c : range) {
    for (const VertexId v : triangulation.cell(c).vertices) {
      if (v != infinite_vertex) ++offsets[v.index() + 1];
    }
  }
  for (std::size_t v = 0; v < num_vertices; ++v) offsets[v + 1] += offsets[v];

  std::vector<CellId> cells(offsets.back());
  std::vector<std::uint32_t> next(offsets.begin(), offsets.end() - 1);
  for (const CellId c : range) {
    for (const VertexId v : triangulation.cell(c).vertices) {
      if (v != infinite_vertex) cells[next[v.index()]++] = c;
    }
  }
  return VertexStars(std::move(offsets), std::move(cells));
}

}  // namespace

VertexStars vertex_stars(const Triangulation& triangulation) {
  return stars_in_range(triangulation, triangulation.cells());
}

VertexStars hull_stars(const Triangulation& triangulation) {
  return stars_in_range(triangulation, triangulation.infinite_cells());
}

}  // namespace cocoon
