// Local change against a fresh build: a connected patch of a large triangulation is replaced.
//
//   dynamic_bench [--points N] [--patch K] [--repetitions R]
//
// For a volume and a surface: builds the triangulation of N points, takes it over, and R times
// replaces the K points nearest to some point by as many others in the same place. The result of
// the last replacement is compared with a fresh build, cell by cell. Prints medians.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include "bench/stopwatch.h"
#include "delaunay/canonical_order.h"
#include "delaunay/delaunay.h"
#include "delaunay/dynamic_delaunay.h"
#include "geom/random.h"
#include "tests/gallery.h"

namespace cocoon {
namespace {

struct Arguments {
  std::size_t points = 1000000;
  std::size_t patch = 5000;
  std::size_t repetitions = 7;
};

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
}

std::vector<VertexId> patch_around(const DynamicDelaunay& dynamic, const Point& center,
                                   std::size_t count) {
  std::vector<VertexId> vertices;
  for (const VertexId v : id_range<VertexId>(dynamic.num_vertex_slots())) {
    if (dynamic.contains(v)) vertices.push_back(v);
  }
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

bool run(const char* name, const std::vector<Point>& points, const Arguments& arguments) {
  Random random(17);
  bench::Stopwatch build;
  Triangulation triangulation = delaunay(points).triangulation;
  const double build_time = build.elapsed().processor;
  DynamicDelaunay dynamic(std::move(triangulation));
  std::vector<double> removal;
  std::vector<double> insertion;
  std::vector<double> replacement;
  DelaunayChange change;
  for (std::size_t k = 0; k < arguments.repetitions; ++k) {
    const std::vector<VertexId> patch =
        patch_around(dynamic, points[random.below(points.size())], arguments.patch);
    const std::vector<Point> others = resampled(dynamic, patch, random);
    bench::Stopwatch both;
    change = dynamic.replace(patch, others);
    replacement.push_back(both.elapsed().processor);
    // The two halves apart: take the new points out, put them in again.
    bench::Stopwatch first;
    dynamic.remove(change.inserted);
    removal.push_back(first.elapsed().processor);
    bench::Stopwatch second;
    dynamic.insert(others);
    insertion.push_back(second.elapsed().processor);
  }
  const double replaced = median(replacement);
  std::printf("%-13s %8zu | %9.1f | %7.2f %7.2f %7.2f | %6.2f %% | %7zu %7zu %7zu\n", name,
              points.size(), 1e3 * build_time, 1e3 * median(removal), 1e3 * median(insertion),
              1e3 * replaced, 100 * replaced / build_time, change.removal.border_vertices,
              change.deleted.size(), change.created.size());
  return equals_fresh_build(dynamic);
}

int run_all(int argc, char** argv) {
  Arguments arguments;
  for (int i = 1; i + 1 < argc; i += 2) {
    const std::size_t value = std::strtoull(argv[i + 1], nullptr, 10);
    if (std::strcmp(argv[i], "--points") == 0) arguments.points = value;
    if (std::strcmp(argv[i], "--patch") == 0) arguments.patch = value;
    if (std::strcmp(argv[i], "--repetitions") == 0) arguments.repetitions = value;
  }
  if (arguments.points < 100 || arguments.patch < 2 || arguments.repetitions == 0) {
    std::fprintf(stderr, "usage: dynamic_bench [--points N] [--patch K] [--repetitions R]\n");
    return 2;
  }
  std::printf("replace a patch of %zu points; processor time in ms, medians of %zu\n",
              arguments.patch, arguments.repetitions);
  std::printf("%-13s %8s | %9s | %7s %7s %7s | %8s | border  deleted created\n", "set", "points",
              "build", "remove", "insert", "replace", "of build");
  const bool ok = run("uniform", gallery::uniform_cube(arguments.points), arguments) &&
                  run("bumpy_sphere", gallery::bumpy_sphere(arguments.points), arguments);
  if (!ok) std::fprintf(stderr, "dynamic_bench: the result differs from a fresh build\n");
  return ok ? 0 : 1;
}

}  // namespace
}  // namespace cocoon

int main(int argc, char** argv) { return cocoon::run_all(argc, argv); }
