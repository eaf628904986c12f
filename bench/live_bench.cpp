// An update of a session against starting over: time by size of the model and of the cloud.
//
//   live_bench [--points N] [--cloud K] [--repetitions R]
//
// A smooth closed surface of N points and scans of patches of about K points, each with a gentle
// hill. For several N at fixed K, and several K at fixed N: the reconstruction of the model, and
// the median of R updates by UpdateSession, with its four steps; one thread, processor time. The
// last model of each session is compared with a reconstruction of its points; if they differ the
// program stops with exit code 1.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "bench/stopwatch.h"
#include "cocone/reconstruct.h"
#include "geom/random.h"
#include "tests/gallery.h"
#include "update/update_session.h"

namespace cocoon {
namespace {

struct Arguments {
  std::size_t points = 1000000;
  std::size_t cloud = 10000;
  std::size_t repetitions = 3;
};

// Distance of the surface from the origin in a direction.
double radius(const Vec3& u) {
  return 1 + 0.1 * std::sin(5 * u.x) * std::cos(4 * u.y + 1) + 0.05 * std::sin(9 * u.z);
}

std::vector<Point> evenly_on_surface(std::size_t n, std::uint64_t seed) {
  Random random(seed);
  std::vector<Point> points = gallery::even_sphere(n);
  const double spacing = std::sqrt(4 * std::numbers::pi / static_cast<double>(n));
  for (Point& p : points) {
    const Vec3 u = unit(p + 0.2 * spacing * random.on_unit_sphere());
    p = radius(u) * u;
  }
  return points;
}

// About k of n points: those around an axis, raised in the middle.
std::vector<Point> scan(std::size_t n, std::size_t k, const Vec3& axis, std::uint64_t seed) {
  const double depth = 2 * static_cast<double>(k) / static_cast<double>(n);
  std::vector<Point> points;
  for (const Point& p : evenly_on_surface(n, seed)) {
    const double t = (1 - dot(unit(p), axis)) / depth;
    if (t >= 1) continue;
    const double rise = t < 0.6 ? (1 - t / 0.6) * (1 - t / 0.6) : 0;
    points.push_back((1 + 0.2 * depth * rise) * p);
  }
  return points;
}

// Processor time of the outermost steps.
struct StepClock : Progress {
  bool report(std::string_view stage, double fraction) override {
    if (stage.find('/') != stage.npos) return true;
    const double now = static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
    if (fraction <= 0) begin[std::string(stage)] = now;
    if (fraction >= 1) seconds[std::string(stage)] = now - begin[std::string(stage)];
    return true;
  }
  std::map<std::string, double> begin;
  std::map<std::string, double> seconds;
};

bool measure(std::size_t n, std::size_t k, std::size_t repetitions) {
  const std::vector<Point> points = evenly_on_surface(n, 1);
  const bench::Stopwatch whole;
  const std::size_t triangles = reconstruct_tight(points).mesh.triangles.size();
  const double full = whole.elapsed().processor;
  UpdateSession session(points);
  struct Run {
    double total;
    std::map<std::string, double> steps;
  };
  std::vector<Run> runs;
  Random random(3);
  std::size_t refused = 0;
  for (std::size_t r = 0; r < repetitions; ++r) {
    const std::vector<std::vector<Point>> clouds{scan(n, k, random.on_unit_sphere(), 7 + r)};
    StepClock clock;
    const bench::Stopwatch stopwatch;
    const SessionUpdate update = session.apply(clouds, {1, &clock});
    runs.push_back({stopwatch.elapsed().processor, clock.seconds});
    refused += update.result.status != UpdateStatus::ok ? 1U : 0U;
  }
  std::sort(runs.begin(), runs.end(), [](const Run& a, const Run& b) { return a.total < b.total; });
  const Run& median = runs[runs.size() / 2];
  const auto step = [&](const char* name) { return 1e3 * median.steps.at(name); };
  std::printf("%8zu %8zu | %8.0f | %8.1f %6.2f %% | %7.1f %7.1f %7.1f %7.1f | %zu of %zu local\n",
              n, k, 1e3 * full, 1e3 * median.total, 100 * median.total / full,
              step("boundary_detection"), step("overlapping_facets"),
              step("segmentation_and_selection"), step("reconstruction"), session.local_changes(),
              repetitions);
  std::fflush(stdout);
  const ReconstructResult again = reconstruct_tight(session.snapshot().points);
  return triangles > 0 && refused == 0 && again.mesh == session.model();
}

int run_all(int argc, char** argv) {
  Arguments arguments;
  for (int i = 1; i + 1 < argc; i += 2) {
    const std::size_t value = std::strtoull(argv[i + 1], nullptr, 10);
    if (std::strcmp(argv[i], "--points") == 0) arguments.points = value;
    if (std::strcmp(argv[i], "--cloud") == 0) arguments.cloud = value;
    if (std::strcmp(argv[i], "--repetitions") == 0) arguments.repetitions = value;
  }
  if (arguments.points < 10000 || arguments.cloud < 500 || arguments.repetitions == 0) {
    std::fprintf(stderr, "usage: live_bench [--points N] [--cloud K] [--repetitions R]\n");
    return 2;
  }
  std::printf("one thread, processor time in ms, medians of %zu\n", arguments.repetitions);
  std::printf("%8s %8s | %8s | %8s %8s | %7s %7s %7s %7s |\n", "points", "cloud", "full", "update",
              "of full", "rim", "overlap", "regions", "surface");
  bool ok = true;
  for (std::size_t n = 10000; n < arguments.points; n *= 10) {
    ok = measure(n, std::min(arguments.cloud, n / 20), arguments.repetitions) && ok;
  }
  for (const std::size_t k : {arguments.cloud / 10, arguments.cloud}) {
    ok = measure(arguments.points, k, arguments.repetitions) && ok;
  }
  if (!ok) std::fprintf(stderr, "live_bench: an update differs from starting over\n");
  return ok ? 0 : 1;
}

}  // namespace
}  // namespace cocoon

int main(int argc, char** argv) { return cocoon::run_all(argc, argv); }
