#include "delaunay/delaunay.h"

#include <string>
#include <utility>
#include <vector>

#include "delaunay/cavity.h"
#include "delaunay/cell_pool.h"
#include "delaunay/first_cells.h"
#include "geom/errors.h"
#include "geom/spatial_order.h"
#include "geom/working_scale.h"

namespace cocoon {
namespace {

// At most about this many cells per point are made on scanned surfaces and in volumes; memory is
// reserved for them, and grows beyond if need be.
constexpr double expected_cells_per_point = 8.0;
constexpr std::size_t progress_interval = std::size_t{1} << 15;

// The different points along the Hilbert curve, and which of them each input point is.
struct Vertices {
  IdVector<VertexId, Point> points;
  IdVector<PointId, VertexId> of_point;
};

Vertices merge_duplicates(Points points, const Execution& execution) {
  Vertices vertices;
  vertices.of_point.resize(points.size());
  vertices.points.reserve(points.size());
  for (const PointId id : hilbert_order(points, execution)) {
    const Point& p = points[id.index()];
    const bool repeated =
        !vertices.points.empty() && vertices.points[VertexId(vertices.points.size() - 1)] == p;
    vertices.of_point[id] =
        repeated ? VertexId(vertices.points.size() - 1) : vertices.points.push_back(p);
  }
  return vertices;
}

// Inserts the vertices one by one, in the given order, whose first four span space. The last
// element of `points` is no vertex (see ConflictSearch).
CellPool insert_all(const IdVector<VertexId, Point>& points,
                    const std::vector<std::uint32_t>& order, DelaunayCounters& counters,
                    const Execution& execution) {
  CellPool pool;
  const auto expected_cells =
      static_cast<std::size_t>(expected_cells_per_point * static_cast<double>(order.size())) + 64;
  pool.cells.reserve(expected_cells);
  pool.marks.reserve(expected_cells);
  make_first_cells(
      pool, points,
      {VertexId(order[0]), VertexId(order[1]), VertexId(order[2]), VertexId(order[3])});
  CavityInserter inserter(pool, points);
  CellId hint(0);
  for (std::size_t i = 4; i < order.size(); ++i) {
    if (i % progress_interval == 0) {
      report_progress(execution, "delaunay",
                      static_cast<double>(i) / static_cast<double>(order.size()));
    }
    const VertexId v(order[i]);
    hint = inserter.insert(v, inserter.find_start(points[v], hint, counters), counters);
  }
  return pool;
}

// The points on which the predicates are fast: a scaled copy where the size is extreme, with one
// element behind the last vertex.
IdVector<VertexId, Point> working_points(const IdVector<VertexId, Point>& points) {
  const double scale = working_scale(points.span());
  IdVector<VertexId, Point> working;
  working.reserve(points.size() + 1);
  const bool scaled = scale != 1 && scales_exactly(points.span(), scale);
  for (const Point& p : points) working.push_back(scaled ? scale * p : p);
  working.push_back({});
  return working;
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
  require_space(bring_simplex_to_front(vertices.points, order), order.size());

  DelaunayCounters counters;
  CellPool pool = insert_all(working_points(vertices.points), order, counters, execution);
  const std::size_t finite_cells = compact_cells(pool);
  report_progress(execution, "delaunay", 1);
  return {Triangulation(
              {std::move(vertices.points), std::move(pool.cells), std::move(vertices.of_point)},
              finite_cells),
          counters};
}

}  // namespace cocoon
