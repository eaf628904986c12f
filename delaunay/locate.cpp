#include "delaunay/locate.h"

#include "geom/orient3d.h"

namespace cocoon {

CellId locate(const IdVector<CellId, Cell>& cells, const IdVector<VertexId, Point>& points,
              const Point& p, CellId start) {
  CellId current = start;
  // From an infinite cell, step through its hull facet: p is seen from inside or beyond.
  if (is_infinite(cells[current])) current = cell_of(cells[current].neighbors[3]);
  int entry = -1;
  for (;;) {
    const Cell& cell = cells[current];
    int exit = -1;
    for (int i = 0; i < 4 && exit < 0; ++i) {
      if (i == entry) continue;  // p lies on this side of the facet that was crossed
      const auto [a, b, c] = facet_vertices(cell, i);
      const Sign side = orient3d(points[a], points[b], points[c], p);
      if (side == Sign::positive) exit = i;
    }
    if (exit < 0) return current;
    const FacetId behind = cell.neighbors[static_cast<std::size_t>(exit)];
    current = cell_of(behind);
    entry = index_of(behind);
    if (is_infinite(cells[current])) return current;
  }
}

}  // namespace cocoon
