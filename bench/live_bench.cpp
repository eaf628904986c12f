// An update of a session against starting over: time by size of the model and of the cloud, and for
// the paper's models.
//
//   live_bench [--points N] [--cloud K] [--repetitions R] [--paper 0] [--svg FILE]
//
// A smooth closed surface and scans of patches of about K points, each with a gentle hill: models
// of 10^4 points to N at fixed K, and clouds of K / 10 to 3 K at N points; then models of random
// samples of the same surface, which always have some boundary samples, and of rough and noisy
// ones, whose surface is not certain. Each row has the medians of R reconstructions of the model,
// and of R updates by UpdateSession, with the four steps of that update; one thread, processor
// time. All are calls that free what they worked with within the clock, but not their results. Then
// the models after Woo & Dey 2005 with all their clouds; undone after each but the last. The
// last model of each session is compared with an update of the one before from scratch; if they
// differ the exit code is 1. --paper 0 leaves these models out. FILE: the two curves.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "bench/log_plot.h"
#include "bench/options.h"
#include "bench/stage_times.h"
#include "bench/stopwatch.h"
#include "cocone/reconstruct.h"
#include "geom/arrays/median.h"
#include "geom/random/random.h"
#include "io/sample_models.h"
#include "tests/gallery.h"
#include "update/update_session.h"

namespace cocoon {
namespace {

struct Arguments {
  std::size_t points;
  std::size_t cloud;
  std::size_t repetitions;
  bool paper;
  std::string svg;  // empty: none
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

// As dense on average, but each sample for itself.
std::vector<Point> randomly_on_surface(std::size_t n, std::uint64_t seed) {
  Random random(seed);
  std::vector<Point> points(n);
  for (Point& p : points) {
    const Vec3 u = random.on_unit_sphere();
    p = radius(u) * u;
  }
  return points;
}

// With noise along the radius, in spacings.
std::vector<Point> with_noise(std::vector<Point> points, double noise, std::uint64_t seed) {
  Random random(seed);
  const double spacing = std::sqrt(4 * std::numbers::pi / static_cast<double>(points.size()));
  for (Point& p : points) p = (1 + noise * spacing * random.gaussian()) * p;
  return points;
}

// The surface is whole, but not certain: flat tetrahedra lie on it.
std::vector<Point> rough(std::size_t n, std::uint64_t seed) {
  return with_noise(evenly_on_surface(n, seed), 0.1, seed + 1);
}

// As real scans: there are samples and cells in doubt, too.
std::vector<Point> noisy(std::size_t n, std::uint64_t seed) {
  return with_noise(randomly_on_surface(n, seed), 0.05, seed + 1);
}

using Samples = std::vector<Point> (*)(std::size_t n, std::uint64_t seed);

// About k of n points: those around an axis, raised in the middle.
std::vector<Point> scan(Samples samples, std::size_t n, std::size_t k, const Vec3& axis,
                        std::uint64_t seed) {
  const double depth = 2 * static_cast<double>(k) / static_cast<double>(n);
  std::vector<Point> points;
  for (const Point& p : samples(n, seed)) {
    const double t = (1 - dot(unit(p), axis)) / depth;
    if (t >= 1) continue;
    const double rise = t < 0.6 ? (1 - t / 0.6) * (1 - t / 0.6) : 0;
    points.push_back((1 + 0.2 * depth * rise) * p);
  }
  return points;
}

struct Row {
  std::string name;
  std::size_t points = 0;
  std::size_t cloud = 0;
  double full = 0;  // ms
  double update = 0;
  bench::StageTimes steps;
  std::size_t local = 0;
  std::size_t updates = 0;
  bool ok = true;
};

double full_reconstruction(const std::vector<Point>& points, std::size_t repetitions) {
  std::vector<double> times;
  for (std::size_t r = 0; r < repetitions; ++r) {
    const bench::Stopwatch whole;
    const ReconstructResult result = reconstruct_tight(points);
    times.push_back(1e3 * whole.elapsed().processor);
  }
  return median(std::move(times));
}

// Updates with these clouds in turn, and takes every one but the last back if `undo`.
Row measure(const std::vector<Point>& points,
            const std::vector<std::vector<std::vector<Point>>>& runs, bool undo) {
  Row row;
  row.points = points.size();
  for (const std::vector<Point>& cloud : runs[0]) row.cloud += cloud.size();
  row.full = full_reconstruction(points, runs.size());
  UpdateSession session(points);
  std::vector<std::pair<double, bench::StageTimes>> times;
  TriangleMesh before;
  for (const std::vector<std::vector<Point>>& clouds : runs) {
    if (&clouds == &runs.back()) before = session.model();
    bench::StageTimes clock;
    const std::size_t local = session.local_changes();
    const bench::Stopwatch stopwatch;
    const SessionUpdate update = session.apply(clouds, {1, &clock});
    times.emplace_back(1e3 * stopwatch.elapsed().processor, std::move(clock));
    row.ok = row.ok && update.result.status == UpdateStatus::ok;
    row.local += session.local_changes() - local;
    if (undo && times.size() < runs.size()) session.undo();
  }
  row.updates = runs.size();
  std::sort(times.begin(), times.end(),
            [](const auto& a, const auto& b) { return a.first < b.first; });
  std::tie(row.update, row.steps) = times[times.size() / 2];
  row.ok = row.ok && update_model(before, runs.back()).mesh == session.model();
  return row;
}

void print(const Row& row) {
  const auto step = [&](const char* name) { return 1e3 * row.steps.seconds(name); };
  std::printf("%-12s %8zu %8zu | %8.0f | %8.1f %7.2f %% | %7.1f %7.1f %7.1f %7.1f | %zu of %zu%s\n",
              row.name.c_str(), row.points, row.cloud, row.full, row.update,
              100 * row.update / row.full, step("boundary_detection"), step("overlapping_facets"),
              step("segmentation_and_selection"), step("reconstruction"), row.local, row.updates,
              row.ok ? "" : "  DIFFERS");
  std::fflush(stdout);
}

Row measure_surface(const std::string& name, Samples samples, std::size_t n, std::size_t k,
                    std::size_t repetitions) {
  Random random(3);
  std::vector<std::vector<std::vector<Point>>> runs;
  for (std::size_t r = 0; r < repetitions; ++r) {
    runs.push_back({scan(samples, n, k, random.on_unit_sphere(), 7 + r)});
  }
  Row row = measure(samples(n, 1), runs, false);
  row.name = name;
  print(row);
  return row;
}

Row measure_smooth(std::size_t n, std::size_t k, std::size_t repetitions) {
  return measure_surface("smooth", evenly_on_surface, n, k, repetitions);
}

Row measure_paper(const std::string& name, std::size_t repetitions) {
  const SampleModel model = sample_model(name);
  Row row = measure(model.initial, std::vector(repetitions, model.clouds), true);
  row.name = name;
  print(row);
  return row;
}

void add(const Row& row, double x, bench::LogPlot& plot) {
  plot.curves[0].points.emplace_back(x, row.full);
  plot.curves[1].points.emplace_back(x, row.update);
}

int run_all(int argc, char** argv) {
  bench::Options options(argc, argv);
  const Arguments arguments{options.number("--points", 1000000), options.number("--cloud", 10000),
                            options.number("--repetitions", 3), options.number("--paper", 1) != 0,
                            options.text("--svg", "")};
  options.require_no_rest();
  if (arguments.points < 10000 || arguments.cloud < 500 || arguments.repetitions == 0) {
    options.fail("needs 10000 points, clouds of 500 and a repetition, or more");
  }
  std::printf("one thread, processor time in ms, medians of %zu\n", arguments.repetitions);
  std::printf("%-12s %8s %8s | %8s | %8s %9s | %7s %7s %7s %7s | local\n", "model", "points",
              "cloud", "full", "update", "of full", "rim", "overlap", "regions", "surface");
  const std::vector<bench::Curve> curves{{"reconstruction of the model", "#888", {}},
                                         {"update", "#06c", {}}};
  const std::size_t fixed = std::min<std::size_t>(arguments.cloud, 500);
  bench::LogPlot by_model{"cloud of " + std::to_string(fixed) + " points", "points of the model",
                          "ms, one thread", curves};
  bench::LogPlot by_cloud{"model of " + std::to_string(arguments.points) + " points",
                          "points of the cloud", "ms, one thread", curves};
  bool ok = true;
  for (double n = 1e4; n <= 1.01 * static_cast<double>(arguments.points); n *= std::sqrt(10.0)) {
    const Row row =
        measure_smooth(static_cast<std::size_t>(std::lround(n)), fixed, arguments.repetitions);
    add(row, n, by_model);
    ok = ok && row.ok;
  }
  for (std::size_t k = arguments.cloud / 10; k <= 3 * arguments.cloud; k *= 3) {
    const Row row = measure_smooth(arguments.points, k, arguments.repetitions);
    add(row, static_cast<double>(row.cloud), by_cloud);
    ok = ok && row.ok;
  }
  const std::pair<const char*, Samples> others[] = {
      {"random", randomly_on_surface}, {"rough", rough}, {"noisy", noisy}};
  for (const auto& [name, samples] : others) {
    for (double n = 1e4; n <= 1.01 * static_cast<double>(arguments.points); n *= 10) {
      const Row row = measure_surface(name, samples, static_cast<std::size_t>(std::lround(n)),
                                      fixed, arguments.repetitions);
      ok = ok && row.ok;
    }
  }
  for (const std::string& name :
       arguments.paper ? sample_model_names() : std::vector<std::string>()) {
    ok = measure_paper(name, arguments.repetitions).ok && ok;
  }
  if (!arguments.svg.empty()) {
    ok = bench::LogPlotWriter::write(arguments.svg, {by_model, by_cloud}) && ok;
  }
  if (!ok) std::fprintf(stderr, "live_bench: an update differs from starting over\n");
  return ok ? 0 : 1;
}

}  // namespace
}  // namespace cocoon

int main(int argc, char** argv) { return cocoon::run_all(argc, argv); }
