#include "delaunay/vertex_stars.h"

#include "geom/arrays/sort_by_vertex.h"

namespace cocoon {

namespace {

// Of every star the cells that lie in a range. They are put in increasing order, so every star
// comes out sorted.
VertexStars stars_in_range(const Triangulation& triangulation, IdRange<CellId> range,
                           const Execution& execution) {
  const std::size_t first = (*range.begin()).index();
  std::vector<CellId> cells;
  std::vector<std::uint32_t> offsets =
      sort_by_vertex((*range.end()).index() - first, triangulation.num_vertices(), execution,
                     [&](std::size_t count) { cells.resize(count); },
                     [&](std::size_t begin, std::size_t end, auto put) {
                       for (CellId c(first + begin); c.index() < first + end; ++c) {
                         for (const VertexId v : triangulation.cell(c).vertices) {
                           if (v != infinite_vertex)
                             put(v, [&](std::uint32_t place) { cells[place] = c; });
                         }
                       }
                     });
  return VertexStars(std::move(offsets), std::move(cells));
}

}  // namespace

VertexStars vertex_stars(const Triangulation& triangulation, const Execution& execution) {
  return stars_in_range(triangulation, triangulation.cells(), execution);
}

VertexStars hull_stars(const Triangulation& triangulation, const Execution& execution) {
  return stars_in_range(triangulation, triangulation.infinite_cells(), execution);
}

}  // namespace cocoon
