#include "delaunay/delaunay.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "delaunay/cavity.h"
#include "delaunay/cell_pool.h"
#include "delaunay/locate.h"
#include "geom/errors.h"
#include "geom/orient3d.h"
#include "geom/spatial_order.h"

namespace cocoon {
namespace {

// At most about this many cells per point are made on scanned surfaces and in volumes; memory is
// reserved for them, and grows beyond if need be.
constexpr double expected_cells_per_point = 8.0;
constexpr std::size_t progress_interval = std::size_t{1} << 15;

void require_finite(Points points) {
  std::size_t bad = 0;
  std::size_t first = 0;
  for (std::size_t i = points.size(); i-- > 0;) {
    if (is_finite(points[i])) continue;
    ++bad;
    first = i;
  }
  if (bad == 0) return;
  throw InputError("point " + std::to_string(first) +
                   " (counted from 0) has a coordinate that is " + "not finite (" +
                   std::to_string(bad) + " such points): remove or repair them");
}

// The different points along the Hilbert curve, and which of them each input point is.
struct Vertices {
  IdVector<VertexId, Point> points;
  IdVector<PointId, VertexId> of_point;
};

Vertices merge_duplicates(Points points, const Execution& execution) {
  Vertices vertices;
  vertices.of_point.resize(points.size());
  vertices.points.reserve(points.size() + 1);
  for (const PointId id : hilbert_order(points, execution)) {
    const Point& p = points[id.index()];
    const bool repeated =
        !vertices.points.empty() && vertices.points[VertexId(vertices.points.size() - 1)] == p;
    vertices.of_point[id] =
        repeated ? VertexId(vertices.points.size() - 1) : vertices.points.push_back(p);
  }
  return vertices;
}

// Moves four vertices that span space to the front of `order`. Errors: InputError.
void bring_simplex_to_front(const IdVector<VertexId, Point>& points,
                            std::vector<std::uint32_t>& order) {
  if (points.size() < 4) {
    throw InputError("only " + std::to_string(points.size()) +
                     " different points: a triangulation of space needs at least 4");
  }
  const auto point = [&](std::size_t i) -> const Point& { return points[VertexId(order[i])]; };
  const auto find_from = [&](std::size_t begin, auto spans) {
    while (begin < order.size() && !spans(begin)) ++begin;
    return begin;
  };
  // All points are different, so the first two always span a line.
  const std::size_t third =
      find_from(2, [&](std::size_t i) { return !are_collinear(point(0), point(1), point(i)); });
  if (third == order.size()) {
    throw InputError("all points lie on one line: no triangulation of space, no surface");
  }
  std::rotate(order.begin() + 2, order.begin() + static_cast<std::ptrdiff_t>(third),
              order.begin() + static_cast<std::ptrdiff_t>(third) + 1);
  const std::size_t fourth = find_from(3, [&](std::size_t i) {
    return orient3d(point(0), point(1), point(2), point(i)) != Sign::zero;
  });
  if (fourth == order.size()) {
    throw InputError("all points lie in one plane: no triangulation of space; " +
                     std::string("a surface needs points off the plane"));
  }
  std::rotate(order.begin() + 3, order.begin() + static_cast<std::ptrdiff_t>(fourth),
              order.begin() + static_cast<std::ptrdiff_t>(fourth) + 1);
}

// One finite cell and the four infinite ones around it.
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

}  // namespace

DelaunayResult delaunay(Points points, const DelaunayOptions& options, const Execution& execution) {
  require_finite(points);
  report_progress(execution, "delaunay", 0);
  if (points.size() >= infinite_vertex.value) {
    throw InputError("too many points: at most " + std::to_string(infinite_vertex.value) +
                     " can be numbered");
  }

  // Number the different points along a space-filling curve, choose the order of insertion.
  Vertices vertices = merge_duplicates(points, execution);
  std::vector<std::uint32_t> order = insertion_rounds(vertices.points.size(), options.seed);
  bring_simplex_to_front(vertices.points, order);

  vertices.points.push_back({});  // conflict_batch reads a little past the last vertex

  // Start with one tetrahedron, insert the other points one by one.
  CellPool pool;
  const auto expected_cells =
      static_cast<std::size_t>(expected_cells_per_point * static_cast<double>(order.size())) + 64;
  pool.cells.reserve(expected_cells);
  pool.marks.reserve(expected_cells);
  make_first_cells(
      pool, vertices.points,
      {VertexId(order[0]), VertexId(order[1]), VertexId(order[2]), VertexId(order[3])});
  DelaunayCounters counters;
  CavityInserter inserter(pool, vertices.points);
  CellId hint(0);
  for (std::size_t i = 4; i < order.size(); ++i) {
    if (i % progress_interval == 0) {
      report_progress(execution, "delaunay",
                      static_cast<double>(i) / static_cast<double>(order.size()));
    }
    const VertexId v(order[i]);
    const WalkResult walk = locate(pool, vertices.points, vertices.points[v], hint);
    counters.walk_steps += walk.steps;
    hint = inserter.insert(v, walk.cell, counters);
  }

  const std::size_t finite_cells = compact_cells(pool);
  vertices.points.raw().pop_back();
  report_progress(execution, "delaunay", 1);
  return {Triangulation(
              {std::move(vertices.points), std::move(pool.cells), std::move(vertices.of_point)},
              finite_cells),
          counters};
}

}  // namespace cocoon
