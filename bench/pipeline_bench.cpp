// The whole way from points to a surface: each stage beside the Delaunay step, the whole beside
// CGAL's, and how much memory it takes.
//
//   pipeline_bench [--points N] [--rival_points N] [--scans FILE,...] [--threads N]
//                  [--benchmark_...]
//
// Stages: the composition of reconstruct.h by hand, on two scans of N points and a real one; its
// mesh must be that of reconstruct_tight. Whole: reconstruct_tight, Tight Cocone on CGAL's
// triangulation (ref/cgal_surface.h: without clean-up), CGAL's advancing front, on scans of
// --rival_points and the files given; ours with all threads, too, and then by the clock. Before
// they are timed each runs once: the first two must be closed, ours the same with all threads, and
// how many triangles they have in common is printed. All are calls that free what they worked with
// within the clock (of CGAL's time 0.2 %), but not their results.
// Repetitions in random alternation; medians. A wrong result makes the exit code 1.
// Memory: peak of a process of its own.
#include <array>
#include <benchmark/benchmark.h>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <string>
#include <unistd.h>
#include <utility>
#include <vector>

#include "bench/common_triangles.h"
#include "bench/options.h"
#include "bench/point_sets.h"
#include "bench/rivals/cgal_surfaces.h"
#include "bench/run_benchmarks.h"
#include "bench/stopwatch.h"
#include "bench/tidy_heap.h"
#include "cocone/candidate_triangles.h"
#include "cocone/extract_manifold.h"
#include "cocone/mark_cells.h"
#include "cocone/marking/certain_surface.h"
#include "cocone/poles.h"
#include "cocone/reconstruct.h"
#include "cocone/surface_mesh.h"
#include "delaunay/voronoi_dual.h"
#include "geom/execution.h"
#include "geom/mesh_check.h"
#include "geom/search/equal_points.h"
#include "io/mesh_file.h"
#include "io/point_file.h"
#include "ref/cgal_surface.h"

namespace cocoon {
namespace {

struct Arguments {
  std::size_t points;
  std::size_t rival_points;
  int threads;
  std::string peak_of;  // internal: the peak of one stage on this set, in a process of its own
  std::string peak_stage;
};

std::vector<Point> make_set(const std::string& name, std::size_t count) {
  if (name != "kitten") return bench::point_set(name, count);
  return read_points(std::string(COCOON_TEST_DATA) + "/points/kitten.xyz").points;
}

// Each point once, which is what the rivals want.
std::vector<Point> read_scan(const std::string& file) {
  const std::vector<Point> points = read_points(file).points;
  const std::vector<RepeatedPoint> repeated = repeated_points(points);
  std::vector<Point> distinct;
  auto next = repeated.begin();
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (next != repeated.end() && next->point == i) {
      ++next;
    } else {
      distinct.push_back(points[i]);
    }
  }
  return distinct;
}

// Medians over the repetitions of one benchmark, by what was timed.
class Times {
 public:
  void add(const std::string& name, const bench::Elapsed& elapsed) {
    seconds_[name].push_back(elapsed);
  }
  bool has(const std::string& name) const { return seconds_.contains(name); }
  double median(const std::string& name,
                double bench::Elapsed::*time = &bench::Elapsed::processor) const {
    return bench::median(seconds_.at(name), time);
  }

 private:
  std::map<std::string, std::vector<bench::Elapsed>> seconds_;
};

template <class Body>
auto timed(Times& times, const std::string& name, Body body) {
  const bench::Stopwatch stopwatch;
  auto result = body();
  times.add(name, stopwatch.elapsed());
  return result;
}

constexpr std::array stage_names = {"delaunay", "poles",    "cocones", "boundary", "candidates",
                                    "prune",    "extract",  "good",    "certain",  "mark",
                                    "peel",     "clean_up", "mesh",    "check",    "write"};

// From the extracted surface to the mesh of the body.
SurfaceMesh run_closing_stages(const Triangulation& t, const Poles& poles,
                               const BoundarySamples& boundary, ManifoldSurface surface,
                               const Execution& execution, Times& times) {
  GoodVertices good = timed(times, "good", [&] {
    return good_vertices(surface.triangles, boundary.boundary, {}, execution);
  });
  if (timed(times, "certain", [&] { return is_certain(t, surface, good, execution); })) {
    return timed(times, "mesh", [&] {
      return surface_of(t, std::move(surface.triangles), surface.halves, execution);
    });
  }
  CellMarks marks = timed(times, "mark", [&] {
    return mark_cells(t, surface.triangles, std::move(good), {}, execution);
  });
  marks = timed(times, "peel", [&] {
    return peel_cells(t, surface.triangles.set, std::move(marks), {}, execution);
  });
  timed(times, "clean_up", [&] { return clean_up_cells(t, poles, marks, {}, execution); });
  return timed(times, "mesh", [&] { return surface_between(t, marks, execution); });
}

// reconstruct_tight with its defaults, stage by stage, then what the program does with the mesh.
TriangleMesh run_stages(Points points, const Execution& execution, Times& times) {
  Triangulation t =
      timed(times, "delaunay", [&] { return delaunay(points, {}, execution).triangulation; });
  DualAndPoles found =
      timed(times, "poles", [&] { return dual_and_poles(t, CoconeOptions().cosine, execution); });
  const Dual& dual = found.dual;
  const Poles& poles = found.poles;
  const Cocones cocones = timed(
      times, "cocones", [&] { return intersect_cocones(t, std::move(found.sides), execution); });
  const BoundarySamples boundary = timed(
      times, "boundary", [&] { return boundary_samples(t, dual, poles, cocones, {}, execution); });
  CandidateTriangles candidates = timed(times, "candidates", [&] {
    return list_candidate_triangles(t, cocones, boundary.boundary, execution);
  });
  PrunedCandidates pruned = timed(
      times, "prune", [&] { return prune_sharp_edges(t, std::move(candidates), {}, execution); });
  ManifoldSurface surface = timed(times, "extract", [&] {
    return extract_manifold(t, std::move(pruned.left), pruned.umbrella, execution);
  });
  const SurfaceMesh mesh =
      run_closing_stages(t, poles, boundary, std::move(surface), execution, times);
  timed(times, "check", [&] { return mesh_check(mesh.mesh); });
  const auto file = std::filesystem::temp_directory_path() /
                    ("pipeline_bench." + std::to_string(getpid()) + ".ply");
  timed(times, "write", [&] {
    write_mesh(file, mesh.mesh);
    return true;
  });
  std::filesystem::remove(file);
  return mesh.mesh;
}

struct Case {
  std::string name;
  std::vector<Point> points;
  std::size_t triangles = 0;  // of ours
  std::size_t plain_triangles = 0;
  Times times = {};
};

// Runs each once, and prints how they compare. False: one that should be closed is not, or ours
// depends on threads.
bool compare_rivals(Case& input, const Execution& execution) {
  const TriangleMesh ours = reconstruct_tight(input.points, {}, execution).mesh;
  TriangleMesh plain;
  plain.points = IdVector<VertexId, Point>(input.points);
  for (const auto& [a, b, c] : ref::cgal_tight_surface(input.points).triangles) {
    plain.triangles.push_back({VertexId(a.value), VertexId(b.value), VertexId(c.value)});
  }
  const TriangleMesh front = rivals::cgal_advancing_front(input.points).mesh;
  input.triangles = ours.triangles.size();
  input.plain_triangles = plain.triangles.size();
  std::printf("%-14s %zu triangles; cgal_tight %zu, %zu in common; advancing front %zu, %zu, %s\n",
              input.name.c_str(), input.triangles, input.plain_triangles,
              bench::common_triangles(ours, plain), front.triangles.size(),
              bench::common_triangles(ours, front),
              mesh_check(front).watertight ? "closed" : "open");
  return mesh_check(ours).balanced && mesh_check(plain).balanced && !front.triangles.empty() &&
         reconstruct_tight(input.points, {}, {.threads = 0}).mesh == ours;
}

// A filter may have left cases out.
std::vector<const Case*> measured(const std::vector<Case>& cases, const std::string& name) {
  std::vector<const Case*> found;
  for (const Case& c : cases) {
    if (c.times.has(name)) found.push_back(&c);
  }
  return found;
}

void print_stages(const std::vector<Case>& all_cases) {
  const std::vector<const Case*> cases = measured(all_cases, "delaunay");
  if (cases.empty()) return;
  std::printf("\nstages: medians of processor time in ms, and parts of the Delaunay step\n%-14s",
              "");
  for (const Case* c : cases) std::printf(" %13.13s %7zu", c->name.c_str(), c->points.size());
  std::printf("\n");
  std::vector<double> after(cases.size(), 0);
  const auto row = [&](const char* name, const std::function<double(std::size_t)>& seconds) {
    std::printf("%-14s", name);
    for (std::size_t i = 0; i < cases.size(); ++i) {
      const double share = seconds(i) / cases[i]->times.median("delaunay");
      std::printf(" %13.1f %6.1f%%", 1e3 * seconds(i), 100 * share);
    }
    std::printf("\n");
  };
  for (const char* name : stage_names) {
    const auto seconds = [&](std::size_t i) {
      return cases[i]->times.has(name) ? cases[i]->times.median(name) : 0;
    };
    for (std::size_t i = 0; i < cases.size(); ++i) {
      after[i] += name == stage_names[0] ? 0 : seconds(i);
    }
    row(name, seconds);
  }
  row("all after it", [&](std::size_t i) { return after[i]; });
}

constexpr const char* all_threads = "cocoon_all_threads";

constexpr std::array rival_names = {"cgal_tight", "cgal_advancing_front"};

// One of ours beside the rivals.
void print_ratios(const Case& c, const std::string& ours, double bench::Elapsed::*time) {
  std::printf("%-14s %7zu", c.name.c_str(), c.points.size());
  const double our_seconds = c.times.median(ours, time);
  std::printf(" | %s %.0f", ours.c_str(), 1e3 * our_seconds);
  for (const char* name : rival_names) {
    if (!c.times.has(name)) continue;
    const double seconds = c.times.median(name, time);
    std::printf(" | %s %.0f (%.1f)", name, 1e3 * seconds, seconds / our_seconds);
  }
  std::printf("\n");
}

void print_rivals(const std::vector<Case>& all_cases) {
  const std::vector<const Case*> cases = measured(all_cases, "cocoon");
  if (cases.empty()) return;
  std::printf("\nwhole: medians of processor time in ms; ratio to Cocoon\n");
  for (const Case* c : cases) print_ratios(*c, "cocoon", &bench::Elapsed::processor);
  const std::vector<const Case*> threaded = measured(all_cases, all_threads);
  if (threaded.empty()) return;
  std::printf("by the clock, ours with all threads (%d)\n", thread_count({.threads = 0}));
  for (const Case* c : threaded) print_ratios(*c, all_threads, &bench::Elapsed::wall);
}

// The highest resident set of this process so far, in MB.
double peak_megabytes() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with("VmHWM:")) return std::strtod(line.c_str() + 6, nullptr) / 1024;
  }
  return 0;
}

// In a process of its own: runs one stage of the way and prints the peak.
int measure_peak(const Arguments& arguments) {
  const std::vector<Point> points = make_set(arguments.peak_of, arguments.points);
  const Execution execution{.threads = arguments.threads};
  std::size_t result = 0;
  if (arguments.peak_stage == "delaunay") {
    result = delaunay(points, {}, execution).triangulation.num_cells();
  } else {
    result = reconstruct_tight(points, {}, execution).mesh.triangles.size();
  }
  std::printf("%f\n", peak_megabytes());
  return result > 0 ? 0 : 1;
}

double peak_of_child(const char* program, const Arguments& arguments, const std::string& set,
                     const char* stage) {
  const std::string command =
      std::string(program) + " --points " + std::to_string(arguments.points) + " --threads " +
      std::to_string(arguments.threads) + " --peak_of " + set + " --peak_stage " + stage;
  FILE* pipe = popen(command.c_str(), "r");
  double megabytes = 0;
  if (pipe == nullptr || std::fscanf(pipe, "%lf", &megabytes) != 1 || pclose(pipe) != 0) {
    std::fprintf(stderr, "pipeline_bench: failed: %s\n", command.c_str());
    std::exit(1);
  }
  return megabytes;
}

void print_memory(const char* program, const Arguments& arguments) {
  std::printf("\npeak memory in MB\n");
  for (const std::string set : {"torus", "bumpy_sphere"}) {
    const double triangulation = peak_of_child(program, arguments, set, "delaunay");
    const double whole = peak_of_child(program, arguments, set, "reconstruct");
    std::printf("%-14s %zu points: delaunay %.0f, whole %.0f (%.2f)\n", set.c_str(),
                arguments.points, triangulation, whole, whole / triangulation);
  }
}

void register_benchmark(const std::string& name,
                        const std::function<void(benchmark::State&)>& body) {
  benchmark::RegisterBenchmark(name.c_str(),
                               [body](benchmark::State& state) {
                                 for ([[maybe_unused]] auto _ : state) body(state);
                               })
      ->Iterations(1)
      ->Unit(benchmark::kMillisecond);
}

void register_stages(Case& input, const Execution& execution) {
  register_benchmark("stages/" + input.name, [&](benchmark::State& state) {
    bench::tidy_heap();
    if (run_stages(input.points, execution, input.times).triangles.size() != input.triangles) {
      bench::fail(state, "stages: wrong number of triangles on " + input.name);
    }
  });
}

void require_triangles(benchmark::State& state, const Case& input, const std::string& program,
                       std::size_t triangles, std::size_t expected) {
  if (triangles == expected) return;
  bench::fail(state, program + ": wrong number of triangles on " + input.name);
}

void register_rivals(Case& input, const Execution& execution) {
  const auto add_ours = [&](const std::string& program, const Execution& how) {
    register_benchmark(program + "/" + input.name, [&, program, how](benchmark::State& state) {
      bench::tidy_heap();
      const ReconstructResult result =
          timed(input.times, program, [&] { return reconstruct_tight(input.points, {}, how); });
      require_triangles(state, input, program, result.mesh.triangles.size(), input.triangles);
    });
  };
  add_ours("cocoon", execution);
  add_ours(all_threads, {.threads = 0});
  register_benchmark("cgal_tight/" + input.name, [&](benchmark::State& state) {
    bench::tidy_heap();
    const ref::CgalSurface result =
        timed(input.times, "cgal_tight", [&] { return ref::cgal_tight_surface(input.points); });
    require_triangles(state, input, "cgal_tight", result.triangles.size(), input.plain_triangles);
  });
  register_benchmark("cgal_advancing_front/" + input.name, [&](benchmark::State& state) {
    bench::tidy_heap();
    const rivals::TimedSurface result = rivals::cgal_advancing_front(input.points);
    input.times.add("cgal_advancing_front", result.elapsed);
    // On noisy points its number of triangles is not the same each time.
    if (result.mesh.triangles.empty()) {
      bench::fail(state, "cgal_advancing_front: no triangles on " + input.name);
    }
  });
}

// Whether the stages by hand give what the composition gives.
bool has_right_stages(Case& input, const Execution& execution) {
  const TriangleMesh expected = reconstruct_tight(input.points, {}, execution).mesh;
  Times untimed;
  input.triangles = expected.triangles.size();
  return run_stages(input.points, execution, untimed) == expected;
}

int fail(const std::string& message) {
  std::fprintf(stderr, "pipeline_bench: %s\n", message.c_str());
  return 1;
}

int run(int argc, char** argv) {
  bench::Options options(argc, argv);
  const Arguments own{options.number("--points", 1000000), options.number("--rival_points", 100000),
                      static_cast<int>(options.number("--threads", 1)),
                      options.text("--peak_of", ""), options.text("--peak_stage", "")};
  if (!own.peak_of.empty()) return measure_peak(own);
  const Execution execution{.threads = own.threads};
  std::vector<Case> scans;
  std::vector<Case> small;
  for (const std::string set : {"torus", "bumpy_sphere", "kitten"}) {
    scans.push_back({.name = set, .points = make_set(set, own.points)});
    small.push_back({.name = set, .points = make_set(set, own.rival_points)});
  }
  for (const std::string& file : options.list("--scans", "")) {
    small.push_back(
        {.name = std::filesystem::path(file).stem().string(), .points = read_scan(file)});
  }
  for (Case& input : scans) {
    if (!has_right_stages(input, execution)) {
      return fail("stages and reconstruct_tight differ on " + input.name);
    }
    register_stages(input, execution);
  }
  for (Case& input : small) {
    if (!compare_rivals(input, execution)) return fail("a wrong surface of " + input.name);
    register_rivals(input, execution);
  }
  const int exit_code = bench::run_benchmarks(options, 3);
  if (exit_code == 2) return 2;
  print_stages(scans);
  print_rivals(small);
  print_memory(argv[0], own);
  return exit_code;
}

}  // namespace
}  // namespace cocoon

int main(int argc, char** argv) {
  try {
    return cocoon::run(argc, argv);
  } catch (const cocoon::Error& error) {  // of --scans
    std::fprintf(stderr, "pipeline_bench: %s\n", error.what());
    return 2;
  }
}
