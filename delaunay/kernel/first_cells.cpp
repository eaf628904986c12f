#include "delaunay/kernel/first_cells.h"

#include <algorithm>
#include <utility>

#include "geom/orient3d.h"

namespace cocoon {

int bring_simplex_to_front(const IdVector<VertexId, Point>& points,
                           std::vector<std::uint32_t>& order) {
  if (order.size() < 2) return 0;
  const auto point = [&](std::size_t i) -> const Point& { return points[VertexId(order[i])]; };
  const auto find_from = [&](std::size_t begin, auto spans) {
    while (begin < order.size() && !spans(begin)) ++begin;
    return begin;
  };
  const auto move_to = [&](std::size_t target, std::size_t from) {
    const auto begin = order.begin();
    std::rotate(begin + static_cast<std::ptrdiff_t>(target),
                begin + static_cast<std::ptrdiff_t>(from),
                begin + static_cast<std::ptrdiff_t>(from) + 1);
  };
  // All points are different, so the first two always span a line.
  const std::size_t third =
      find_from(2, [&](std::size_t i) { return !are_collinear(point(0), point(1), point(i)); });
  if (third == order.size()) return 1;
  move_to(2, third);
  const std::size_t fourth = find_from(3, [&](std::size_t i) {
    return orient3d(point(0), point(1), point(2), point(i)) != Sign::zero;
  });
  if (fourth == order.size()) return 2;
  move_to(3, fourth);
  return 3;
}

void make_first_cells(CellPool& pool, const IdVector<VertexId, Point>& points,
                      std::array<VertexId, 4> corners) {
  if (orient3d(points[corners[0]], points[corners[1]], points[corners[2]], points[corners[3]]) ==
      Sign::negative) {
    std::swap(corners[2], corners[3]);
  }
  pool.cells.resize(5);
  pool.marks.resize(5, CellMark::untested);
  const CellId inner(0);
  pool.cells[inner].vertices = corners;
  // Behind facet i lies infinite cell 1 + i, whose first three vertices are the facet's corners in
  // the order seen from outside.
  for (int i = 0; i < 4; ++i) {
    Cell& outer = pool.cells[CellId(1 + i)];
    for (std::size_t k = 0; k < 3; ++k) {
      outer.vertices[k] = corners[static_cast<std::size_t>(facet_corners[i][k])];
    }
    outer.vertices[3] = infinite_vertex;
    outer.neighbors[3] = facet_id(inner, i);
    pool.cells[inner].neighbors[static_cast<std::size_t>(i)] = facet_id(CellId(1 + i), 3);
    // Opposite the corner from facet k of the inner cell lies the infinite cell behind facet k.
    for (std::size_t k = 0; k < 3; ++k) {
      const int across = facet_corners[i][k];
      const int* theirs = facet_corners[across];
      const int slot = static_cast<int>(std::find(theirs, theirs + 3, i) - theirs);
      outer.neighbors[k] = facet_id(CellId(1 + across), slot);
    }
  }
}

}  // namespace cocoon
