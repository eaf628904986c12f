// Local change against a fresh build: a connected patch of a large triangulation is replaced.
//
//   dynamic_bench [--points N] [--patch K] [--repetitions R]
//
// For a volume and a surface: builds the triangulation of N points, takes it over, and R times
// replaces the K points nearest to some point by as many others in the same place, at once; then
// again, the old points removed first and the others inserted after that, which is what CGAL's
// triangulation of the same points does beside it, in turn. Then single vertices. After each patch
// the cells are compared with CGAL's, and at the end with a fresh build; if they differ the exit
// code is 1. Prints medians of processor time.
#include <algorithm>
#include <cstdio>
#include <span>
#include <utility>
#include <vector>

#include "bench/options.h"
#include "bench/place_set_hash.h"
#include "bench/rivals/cgal.h"
#include "bench/stopwatch.h"
#include "bench/tidy_heap.h"
#include "delaunay/canonical_order.h"
#include "delaunay/delaunay.h"
#include "delaunay/dynamic_delaunay.h"
#include "geom/arrays/median.h"
#include "geom/random/random.h"
#include "tests/gallery.h"

namespace cocoon {
namespace {

struct Arguments {
  std::size_t points;
  std::size_t patch;
  std::size_t repetitions;
};

// What was measured on one set, in seconds of processor time.
struct Times {
  double build = 0;
  std::vector<double> removal;
  std::vector<double> insertion;
  std::vector<double> replacement;
  std::vector<double> cgal_removal;
  std::vector<double> cgal_insertion;
  double single = 0;    // one vertex removed, one inserted
  DelaunayChange last;  // of a replacement
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
  points.reserve(vertices.size());
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

// The points of a patch, and as many others in its place.
struct Patch {
  std::vector<VertexId> vertices;
  std::vector<Point> gone;
  std::vector<Point> others;
};

void measure_ours(DynamicDelaunay& dynamic, const Patch& patch, Times& times) {
  bench::tidy_heap();
  const bench::Stopwatch both;
  times.last = dynamic.replace(patch.vertices, patch.others);
  times.replacement.push_back(both.elapsed().processor);

  // The old points again, to take the two halves apart as CGAL does. It has just looked for the
  // vertices, so there, too, the patch is in the caches.
  const DelaunayChange restored = dynamic.replace(times.last.inserted, patch.gone);
  bench::tidy_heap();
  const bench::Stopwatch removal;
  const DelaunayChange removed = dynamic.remove(restored.inserted);
  times.removal.push_back(removal.elapsed().processor);
  const bench::Stopwatch insertion;
  const DelaunayChange inserted = dynamic.insert(patch.others);
  times.insertion.push_back(insertion.elapsed().processor);
}

void measure_cgal(rivals::CgalDynamicDelaunay& cgal, const Patch& patch, Times& times) {
  bench::tidy_heap();
  const rivals::TimedReplacement replacement = cgal.replace(patch.gone, patch.others);
  times.cgal_removal.push_back(replacement.removal.processor);
  times.cgal_insertion.push_back(replacement.insertion.processor);
}

// Both in turn, now one first and now the other. Whether they have the same cells then.
bool measure_patch(DynamicDelaunay& dynamic, rivals::CgalDynamicDelaunay& cgal, const Patch& patch,
                   bool cgal_first, Times& times) {
  if (cgal_first) measure_cgal(cgal, patch, times);
  measure_ours(dynamic, patch, times);
  if (!cgal_first) measure_cgal(cgal, patch, times);
  return bench::place_set_hash(dynamic.freeze().triangulation) == cgal.place_set_hash();
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
  rivals::CgalDynamicDelaunay cgal(points);
  bool agrees = true;
  for (std::size_t k = 0; k < arguments.repetitions; ++k) {
    Patch patch;
    patch.vertices = patch_around(dynamic, points[random.below(points.size())], arguments.patch);
    patch.gone = points_of(dynamic, patch.vertices);
    patch.others = resampled(dynamic, patch.vertices, random);
    agrees = measure_patch(dynamic, cgal, patch, k % 2 == 1, times) && agrees;
  }
  measure_single(dynamic, random, times);
  const double replaced = median(times.replacement);
  std::printf("%-13s %8zu | %7.1f | %7.2f %7.2f %7.2f %6.2f %% | %8.2f %8.2f | %6.1f | %7zu\n",
              name, points.size(), 1e3 * times.build, 1e3 * median(times.removal),
              1e3 * median(times.insertion), 1e3 * replaced, 100 * replaced / times.build,
              1e3 * median(times.cgal_removal), 1e3 * median(times.cgal_insertion),
              1e6 * times.single, times.last.created.size());
  return agrees && equals_fresh_build(dynamic);
}

int run_all(int argc, char** argv) {
  bench::Options options(argc, argv);
  const Arguments arguments{options.number("--points", 1000000), options.number("--patch", 5000),
                            options.number("--repetitions", 7)};
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
  if (!ok) {
    std::fprintf(stderr, "dynamic_bench: the result differs from a fresh build or from CGAL\n");
  }
  return ok ? 0 : 1;
}

}  // namespace
}  // namespace cocoon

int main(int argc, char** argv) { return cocoon::run_all(argc, argv); }
