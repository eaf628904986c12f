// Local change against a fresh build: a connected patch of a large triangulation is replaced.
//
//   dynamic_bench [--points N] [--patch K] [--repetitions R] [--cgal C]
//
// For a volume and a surface: builds the triangulation of N points, takes it over, and R times
// replaces the K points nearest to some point by as many others in the same place; then single
// vertices. The last C patches are also replaced in CGAL's triangulation of the same points. The
// results are compared: with a fresh build, cell by cell, and the number of cells with CGAL's.
// Prints medians.
#include <algorithm>
#include <cstdio>
#include <span>
#include <utility>
#include <vector>

#include "bench/options.h"
#include "bench/rivals/cgal.h"
#include "bench/stopwatch.h"
#include "bench/tidy_heap.h"
#include "delaunay/canonical_order.h"
#include "delaunay/delaunay.h"
#include "delaunay/dynamic_delaunay.h"
#include "geom/median.h"
#include "geom/random.h"
#include "tests/gallery.h"

namespace cocoon {
namespace {

struct Arguments {
  std::size_t points;
  std::size_t patch;
  std::size_t repetitions;
  std::size_t cgal;
};

// What was measured on one set, in seconds of processor time.
struct Times {
  double build = 0;
  std::vector<double> removal;
  std::vector<double> insertion;
  std::vector<double> replacement;
  std::vector<double> cgal_removal;
  std::vector<double> cgal_insertion;
  double single = 0;  // one vertex removed, one inserted
  DelaunayChange last;
  bool agrees = true;
};

std::vector<VertexId> live_vertices(const DynamicDelaunay& dynamic) {
  std::vector<VertexId> vertices;
  for (const VertexId v : id_range<VertexId>(dynamic.num_vertex_slots())) {
    if (dynamic.contains(v)) vertices.push_back(v);
  }
  return vertices;
}

std::vector<Point> points_of(const DynamicDelaunay& dynamic,
                             const std::vector<VertexId>& vertices) {
  std::vector<Point> points;
  for (const VertexId v : vertices) points.push_back(dynamic.point(v));
  return points;
}

std::vector<VertexId> patch_around(const DynamicDelaunay& dynamic, const Point& center,
                                   std::size_t count) {
  std::vector<VertexId> vertices = live_vertices(dynamic);
  const auto nearer = [&](VertexId a, VertexId b) {
    return squared_distance(dynamic.point(a), center) < squared_distance(dynamic.point(b), center);
  };
  const std::size_t kept = std::min(count, vertices.size());
  std::nth_element(vertices.begin(), vertices.begin() + static_cast<std::ptrdiff_t>(kept) - 1,
                   vertices.end(), nearer);
  vertices.resize(kept);
  return vertices;
}

// As many points again: each between a point of the patch and a neighbor in the list, which was cut
// out of a Hilbert-ordered array, and so usually near it in space.
std::vector<Point> resampled(const DynamicDelaunay& dynamic, std::vector<VertexId> patch,
                             Random& random) {
  std::sort(patch.begin(), patch.end());
  std::vector<Point> points;
  for (std::size_t i = 0; i < patch.size(); ++i) {
    const Point& p = dynamic.point(patch[i]);
    const Point& q = dynamic.point(patch[i == 0 ? 1 : i - 1]);
    points.push_back(p + (0.3 + 0.4 * random.uniform()) * (q - p));
  }
  return points;
}

bool equals_fresh_build(const DynamicDelaunay& dynamic) {
  const Triangulation frozen = canonical_order(dynamic.freeze().triangulation);
  const Triangulation fresh = canonical_order(delaunay(frozen.points().span()).triangulation);
  return frozen.cell_records() == fresh.cell_records();
}

void measure_patch(DynamicDelaunay& dynamic, const Point& center, const Arguments& arguments,
                   bool with_cgal, Random& random, Times& times) {
  const std::vector<VertexId> patch = patch_around(dynamic, center, arguments.patch);
  const std::vector<Point> others = resampled(dynamic, patch, random);
  std::vector<Point> all;
  const std::vector<Point> gone = points_of(dynamic, patch);
  if (with_cgal) all = points_of(dynamic, live_vertices(dynamic));

  bench::tidy_heap();
  const bench::Stopwatch both;
  times.last = dynamic.replace(patch, others);
  times.replacement.push_back(both.elapsed().processor);
  // The two halves apart: take the new points out, put them in again.
  const bench::Stopwatch first;
  dynamic.remove(times.last.inserted);
  times.removal.push_back(first.elapsed().processor);
  const bench::Stopwatch second;
  dynamic.insert(others);
  times.insertion.push_back(second.elapsed().processor);

  if (!with_cgal) return;
  bench::tidy_heap();
  const rivals::TimedReplacement cgal = rivals::cgal_replace(all, gone, others);
  times.cgal_removal.push_back(cgal.removal.processor);
  times.cgal_insertion.push_back(cgal.insertion.processor);
  times.agrees =
      times.agrees && cgal.finite_cells == dynamic.freeze().triangulation.num_finite_cells();
}

// Vertices here and there, one after the other.
void measure_single(DynamicDelaunay& dynamic, Random& random, Times& times) {
  constexpr std::size_t count = 1000;
  const std::vector<VertexId> live = live_vertices(dynamic);
  std::vector<VertexId> vertices;
  for (std::size_t k = 0; k < count; ++k) vertices.push_back(live[k * live.size() / count]);
  random.shuffle(vertices);
  const bench::Stopwatch stopwatch;
  for (const VertexId v : vertices) {
    const Point p = dynamic.point(v);
    dynamic.remove(std::span(&v, 1));
    dynamic.insert(std::span(&p, 1));
  }
  times.single = stopwatch.elapsed().processor / static_cast<double>(count);
}

bool run(const char* name, const std::vector<Point>& points, const Arguments& arguments) {
  Random random(17);
  Times times;
  const bench::Stopwatch build;
  Triangulation triangulation = delaunay(points).triangulation;
  times.build = build.elapsed().processor;
  DynamicDelaunay dynamic(std::move(triangulation));
  for (std::size_t k = 0; k < arguments.repetitions; ++k) {
    const bool with_cgal = k + arguments.cgal >= arguments.repetitions;
    measure_patch(dynamic, points[random.below(points.size())], arguments, with_cgal, random,
                  times);
  }
  measure_single(dynamic, random, times);
  const double replaced = median(times.replacement);
  std::printf("%-13s %8zu | %7.1f | %7.2f %7.2f %7.2f %6.2f %% | %8.2f %8.2f | %6.1f | %7zu\n",
              name, points.size(), 1e3 * times.build, 1e3 * median(times.removal),
              1e3 * median(times.insertion), 1e3 * replaced, 100 * replaced / times.build,
              1e3 * median(times.cgal_removal), 1e3 * median(times.cgal_insertion),
              1e6 * times.single, times.last.created.size());
  return times.agrees && equals_fresh_build(dynamic);
}

int run_all(int argc, char** argv) {
  bench::Options options(argc, argv);
  const Arguments arguments{options.number("--points", 1000000), options.number("--patch", 5000),
                            options.number("--repetitions", 7), options.number("--cgal", 1)};
  options.require_no_rest();
  if (arguments.points < 100 || arguments.patch < 2 || arguments.repetitions == 0) {
    options.fail("needs 100 points, patches of 2 and a repetition, or more");
  }
  std::printf("replace a patch of %zu points; processor time in ms, medians of %zu\n",
              arguments.patch, arguments.repetitions);
  std::printf("%-13s %8s | %7s | %7s %7s %7s %8s | %8s %8s | %6s |\n", "", "", "", "remove",
              "insert", "replace", "of build", "CGAL", "CGAL", "one v.");
  std::printf("%-13s %8s | %7s | %7s %7s %7s %8s | %8s %8s | %6s | created\n", "set", "points",
              "build", "", "", "", "", "remove", "insert", "us");
  const bool ok = run("uniform", gallery::uniform_cube(arguments.points), arguments) &&
                  run("bumpy_sphere", gallery::bumpy_sphere(arguments.points), arguments);
  if (!ok)
    std::fprintf(stderr, "dynamic_bench: the result differs from a fresh build or from CGAL\n");
  return ok ? 0 : 1;
}

}  // namespace
}  // namespace cocoon

int main(int argc, char** argv) { return cocoon::run_all(argc, argv); }
