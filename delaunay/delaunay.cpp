#include "delaunay/delaunay.h"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "delaunay/kernel/cavity.h"
#include "delaunay/kernel/cell_pool.h"
#include "delaunay/kernel/first_cells.h"
#include "delaunay/kernel/parallel_insertion.h"
#include "delaunay/require_points.h"
#include "geom/arrays/large_pages.h"
#include "geom/spatial_order.h"
#include "geom/working_scale.h"

namespace cocoon {
namespace {

// Fewer cells per point are made on scanned surfaces and in volumes. Address space is reserved for
// so many, since memory is taken only where it is written to; it grows beyond if need be.
constexpr double expected_cells_per_point = 10.0;
constexpr std::size_t copy_grain = std::size_t{1} << 15;
constexpr std::size_t progress_interval = std::size_t{1} << 15;

// Threads do not pay for fewer points, and while there are so few for each they are in each
// other's way.
constexpr std::size_t min_points_for_threads = 3000;
constexpr std::size_t points_before_threads = 150;

// The different points along the Hilbert curve, and which of them each input point is.
struct Vertices {
  IdVector<VertexId, Point> points;
  IdVector<PointId, VertexId> of_point;
};

// The points have room for one more element, which the kernel wants.
Vertices merge_duplicates(Points points, const Execution& execution) {
  const std::vector<PointId> order = hilbert_order(points, execution);
  Vertices vertices;
  vertices.of_point.resize(points.size());
  vertices.points.reserve(points.size() + 1);
  prefer_large_pages(vertices.points.raw());
  vertices.points.resize(points.size());
  // Each chunk copies its points, without those equal to the one before, to where it begins.
  std::vector<std::uint8_t> is_new(points.size());
  std::vector<std::size_t> counts((points.size() + copy_grain - 1) / copy_grain);
  parallel_chunks(execution, points.size(), copy_grain, [&](std::size_t begin, std::size_t end) {
    std::size_t next = begin;
    for (std::size_t i = begin; i < end; ++i) {
      const Point& p = points[order[i].index()];
      is_new[i] = i == 0 || p != points[order[i - 1].index()] ? 1 : 0;
      if (is_new[i] != 0) vertices.points[VertexId(next++)] = p;
    }
    counts[begin / copy_grain] = next - begin;
  });
  // Close the gaps.
  std::size_t count = 0;
  for (std::size_t chunk = 0; chunk < counts.size(); ++chunk) {
    const auto first = vertices.points.begin() + static_cast<std::ptrdiff_t>(chunk * copy_grain);
    const auto last = first + static_cast<std::ptrdiff_t>(counts[chunk]);
    if (count != chunk * copy_grain) {
      std::copy(first, last, vertices.points.begin() + static_cast<std::ptrdiff_t>(count));
    }
    count += std::exchange(counts[chunk], count);
  }
  vertices.points.resize(count);
  parallel_chunks(execution, points.size(), copy_grain, [&](std::size_t begin, std::size_t end) {
    std::size_t next = counts[begin / copy_grain];
    for (std::size_t i = begin; i < end; ++i) {
      next += is_new[i];
      vertices.of_point[order[i]] = VertexId(next - 1);
    }
  });
  return vertices;
}

// How many of the first points to insert on one thread.
std::size_t num_one_by_one(std::size_t count, const Execution& execution) {
  const auto threads = static_cast<std::size_t>(thread_count(execution));
  if (threads == 1 || count < min_points_for_threads) return count;
  return std::min(count, points_before_threads * threads);
}

// Inserts the vertices in the given order, whose first four span space. The last element of
// `points` is no vertex (see ConflictSearch).
CellPool insert_all(const IdVector<VertexId, Point>& points, const InsertionRounds& rounds,
                    DelaunayCounters& counters, const Execution& execution) {
  const std::vector<std::uint32_t>& order = rounds.order;
  CellPool pool;
  const auto expected_cells =
      static_cast<std::size_t>(expected_cells_per_point * static_cast<double>(order.size())) + 64;
  pool.cells.reserve(expected_cells);
  pool.marks.reserve(expected_cells);
  prefer_large_pages(pool.cells.raw());
  prefer_large_pages(pool.marks.raw());
  make_first_cells(
      pool, points,
      {VertexId(order[0]), VertexId(order[1]), VertexId(order[2]), VertexId(order[3])});
  CavityInserter inserter(pool, points, execution);
  CellId hint(0);
  const std::size_t one_by_one = num_one_by_one(order.size(), execution);
  for (std::size_t i = 4; i < one_by_one; ++i) {
    if (i % progress_interval == 0) {
      report_progress(execution, "delaunay",
                      static_cast<double>(i) / static_cast<double>(order.size()));
    }
    const VertexId v(order[i]);
    hint = inserter.insert(v, inserter.find_start(points[v], hint, counters), counters);
  }
  if (one_by_one < order.size()) {
    insert_in_parallel(pool, points, inserter, order, rounds.ends, one_by_one, counters, execution);
  }
  return pool;
}

// A scaled copy of the points on which the predicates are fast; empty if they are so already.
IdVector<VertexId, Point> scaled_points(const IdVector<VertexId, Point>& points,
                                        const Execution& execution) {
  const double scale = working_scale(points.span(), execution);
  IdVector<VertexId, Point> scaled;
  if (scale == 1 || !scales_exactly(points.span(), scale)) return scaled;
  scaled.reserve(points.size() + 1);
  prefer_large_pages(scaled.raw());
  for (const Point& p : points) scaled.push_back(scale * p);
  return scaled;
}

}  // namespace

DelaunayCounters& DelaunayCounters::operator+=(const DelaunayCounters& other) {
  walk_steps += other.walk_steps;
  conflict_tests += other.conflict_tests;
  cells_created += other.cells_created;
  cells_deleted += other.cells_deleted;
  wide_inspheres += other.wide_inspheres;
  exact_inspheres += other.exact_inspheres;
  perturbed_inspheres += other.perturbed_inspheres;
  retries += other.retries;
  stolen_runs += other.stolen_runs;
  return *this;
}

DelaunayResult delaunay(Points points, const DelaunayOptions& options, const Execution& execution) {
  require_ids(points.size());
  require_finite(points, execution);
  report_progress(execution, "delaunay", 0);

  // Number the different points along a space-filling curve, choose the order of insertion.
  Vertices vertices = merge_duplicates(points, execution);
  InsertionRounds rounds = insertion_rounds(vertices.points.size(), options.seed, execution);
  require_space(bring_simplex_to_front(vertices.points, rounds.order), rounds.order.size());

  DelaunayCounters counters;
  IdVector<VertexId, Point> scaled = scaled_points(vertices.points, execution);
  IdVector<VertexId, Point>& working = scaled.empty() ? vertices.points : scaled;
  working.push_back({});
  CellPool pool = insert_all(working, rounds, counters, execution);
  working.resize(working.size() - 1);
  const std::size_t finite_cells = compact_cells(pool, execution);
  report_progress(execution, "delaunay", 1);
  return {Triangulation(
              {std::move(vertices.points), std::move(pool.cells), std::move(vertices.of_point)},
              finite_cells, execution),
          counters};
}

}  // namespace cocoon
