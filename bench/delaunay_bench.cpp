// The Delaunay kernel beside CGAL's and TetGen's, on the point sets of tests/gallery.h.
//
//   delaunay_bench [--points N[,N...]] [--sets NAME[,NAME...]] [--threads N] [--benchmark_...]
//
// Every set is first triangulated by ours and CGAL's and the cells compared; unequal cells are an
// error. Then repetitions of all run in random alternation, so that whatever else the machine does
// hits all alike, and a table gives medians and their ratios.
#include <algorithm>
#include <benchmark/benchmark.h>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "bench/rivals/cgal.h"
#include "bench/rivals/tetgen.h"
#include "bench/run_benchmarks.h"
#include "bench/stopwatch.h"
#include "delaunay/delaunay.h"
#include "geom/random.h"
#include "ref/cell_set.h"
#include "tests/gallery.h"

namespace cocoon {
namespace {

struct Arguments {
  std::vector<std::string> sizes{"100000"};
  std::vector<std::string> sets{"uniform", "torus",  "bumpy_sphere", "exact_torus",
                                "grid",    "sphere", "box"};
  int threads = 1;
};

// Random angles on a torus of radii 1 and 0.35, as exactly as doubles allow: spheres touch the tube
// along whole circles, so three times as many cells as on a scan, with spheres that nearly agree.
std::vector<Point> exact_torus(std::size_t count) {
  Random random(1);
  std::vector<Point> points;
  points.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double u = random.uniform(0, 2 * std::numbers::pi);
    const double v = random.uniform(0, 2 * std::numbers::pi);
    const double ring = 1 + 0.35 * std::cos(v);
    points.push_back({ring * std::cos(u), ring * std::sin(u), 0.35 * std::sin(v)});
  }
  return points;
}

// About `count` points of the named set; empty for a name that does not exist.
std::vector<Point> make_set(const std::string& name, std::size_t count) {
  const auto n = static_cast<double>(count);
  if (name == "uniform") return gallery::uniform_cube(count);
  if (name == "torus") return gallery::displaced_torus(count);
  if (name == "bumpy_sphere") return gallery::bumpy_sphere(count);
  if (name == "exact_torus") return exact_torus(count);
  if (name == "grid") return gallery::integer_grid(static_cast<int>(std::lround(std::cbrt(n))));
  if (name == "sphere") return gallery::sphere(count);
  if (name == "box") return gallery::box_faces(static_cast<int>(std::lround(std::sqrt(n / 52))));
  return {};
}

std::vector<std::string> split(const std::string& list) {
  std::vector<std::string> parts;
  std::istringstream stream(list);
  for (std::string part; std::getline(stream, part, ',');) parts.push_back(part);
  return parts;
}

// Takes our own arguments out of argv and leaves Google Benchmark's.
Arguments parse_arguments(std::vector<char*>& argv) {
  Arguments arguments;
  std::vector<char*> rest{argv[0]};
  for (std::size_t i = 1; i < argv.size(); ++i) {
    const std::string name = argv[i];
    const bool has_value = i + 1 < argv.size();
    if (name == "--points" && has_value) {
      arguments.sizes = split(argv[++i]);
    } else if (name == "--sets" && has_value) {
      arguments.sets = split(argv[++i]);
    } else if (name == "--threads" && has_value) {
      arguments.threads = std::atoi(argv[++i]);
    } else {
      rest.push_back(argv[i]);
    }
  }
  argv = rest;
  return arguments;
}

// One input, and what was measured on it.
struct Case {
  std::string name;
  std::vector<Point> points;
  std::size_t finite_cells = 0;
  std::vector<bench::Elapsed> ours;  // by repetition
  std::vector<bench::Elapsed> cgal;
  std::vector<bench::Elapsed> tetgen;
};

// On these sets TetGen breaks ties between cospherical points in its own way.
bool has_ties(const Case& input) { return input.name == "grid" || input.name == "box"; }

bool has_equal_cells(Case& input, const Execution& execution) {
  const Triangulation ours = delaunay(input.points, {}, execution).triangulation;
  input.finite_cells = ours.num_finite_cells();
  return ref::cell_set_hash(ours) == rivals::cgal_cell_set_hash(input.points);
}

void run_ours(benchmark::State& state, Case& input, const Execution& execution) {
  for ([[maybe_unused]] auto _ : state) {
    const bench::Stopwatch stopwatch;
    const DelaunayResult result = delaunay(input.points, {}, execution);
    const bench::Elapsed elapsed = stopwatch.elapsed();
    if (result.triangulation.num_finite_cells() != input.finite_cells) {
      state.SkipWithError("wrong number of cells");
    }
    state.SetIterationTime(elapsed.wall);
    input.ours.push_back(elapsed);
  }
  state.counters["points"] = static_cast<double>(input.points.size());
}

void run_cgal(benchmark::State& state, Case& input) {
  for ([[maybe_unused]] auto _ : state) {
    const rivals::TimedBuild build = rivals::cgal_delaunay(input.points);
    if (build.finite_cells != input.finite_cells) state.SkipWithError("wrong number of cells");
    state.SetIterationTime(build.elapsed.wall);
    input.cgal.push_back(build.elapsed);
  }
  state.counters["points"] = static_cast<double>(input.points.size());
}

void run_tetgen(benchmark::State& state, Case& input) {
  for ([[maybe_unused]] auto _ : state) {
    const rivals::TimedBuild build = rivals::tetgen_delaunay(input.points);
    if (build.finite_cells != input.finite_cells && !has_ties(input)) {
      state.SkipWithError("wrong number of cells");
    }
    state.SetIterationTime(build.elapsed.wall);
    input.tetgen.push_back(build.elapsed);
  }
  state.counters["points"] = static_cast<double>(input.points.size());
}

// The median of one of the two times, in ns per point.
double median(const std::vector<bench::Elapsed>& runs, double bench::Elapsed::*time,
              std::size_t points) {
  std::vector<double> values;
  for (const bench::Elapsed& run : runs) values.push_back(run.*time);
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  const double seconds =
      values.size() % 2 == 1 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
  return seconds * 1e9 / static_cast<double>(points);
}

// The widest deviation of a run of any kernel from its median, in processor time, percent.
double spread(const Case& input) {
  double widest = 0;
  for (const auto* runs : {&input.ours, &input.cgal, &input.tetgen}) {
    if (runs->empty()) continue;
    const double middle = median(*runs, &bench::Elapsed::processor, 1) * 1e-9;
    for (const bench::Elapsed& run : *runs) {
      widest = std::max(widest, std::fabs(run.processor / middle - 1));
    }
  }
  return 100 * widest;
}

void print_table(const std::vector<Case>& cases) {
  std::printf("\nmedians in ns per point; ratio = rival / Cocoon\n");
  std::printf("%34s | %33s | %33s |\n", "", "wall-clock", "processor");
  std::printf("%-14s %9s %9s", "set", "points", "cells");
  for (int clock = 0; clock < 2; ++clock) {
    std::printf(" | %6s %6s %5s %7s %5s", "Cocoon", "CGAL", "ratio", "TetGen", "ratio");
  }
  std::printf(" | spread\n");
  for (const Case& input : cases) {
    if (input.ours.empty() || input.cgal.empty() || input.tetgen.empty()) continue;
    std::printf("%-14s %9zu %9zu", input.name.c_str(), input.points.size(), input.finite_cells);
    for (const auto time : {&bench::Elapsed::wall, &bench::Elapsed::processor}) {
      const double ours = median(input.ours, time, input.points.size());
      const double cgal = median(input.cgal, time, input.points.size());
      const double tetgen = median(input.tetgen, time, input.points.size());
      std::printf(" | %6.0f %6.0f %5.2f %7.0f %5.2f", ours, cgal, cgal / ours, tetgen,
                  tetgen / ours);
    }
    std::printf(" | %4.0f %%\n", spread(input));
  }
}

// Makes the inputs of all sets and sizes; stops the program if the two kernels disagree.
std::vector<Case> make_cases(const Arguments& arguments, const Execution& execution) {
  std::vector<Case> cases;
  for (const std::string& set : arguments.sets) {
    for (const std::string& size : arguments.sizes) {
      Case input{set, make_set(set, std::strtoull(size.c_str(), nullptr, 10)), 0, {}, {}, {}};
      if (input.points.size() < 4) {
        std::fprintf(stderr, "delaunay_bench: no set '%s' of %s points\n", set.c_str(),
                     size.c_str());
        std::exit(2);
      }
      if (!has_equal_cells(input, execution)) {
        std::fprintf(stderr, "delaunay_bench: cells differ from CGAL's on %s %s\n", set.c_str(),
                     size.c_str());
        std::exit(1);
      }
      cases.push_back(std::move(input));
    }
  }
  return cases;
}

int run(int argc, char** argv) {
  std::vector<char*> arguments(argv, argv + argc);
  const Arguments own = parse_arguments(arguments);
  const Execution execution{.threads = own.threads};
  std::vector<Case> cases = make_cases(own, execution);
  for (Case& input : cases) {
    const auto add = [&](const std::string& kernel, auto run_kernel) {
      const std::string name =
          kernel + "/" + input.name + "/" + std::to_string(input.points.size());
      benchmark::RegisterBenchmark(name.c_str(), run_kernel)
          ->Iterations(1)
          ->UseManualTime()
          ->Unit(benchmark::kMillisecond);
    };
    add("cocoon", [&](benchmark::State& state) { run_ours(state, input, execution); });
    add("cgal", [&](benchmark::State& state) { run_cgal(state, input); });
    add("tetgen", [&](benchmark::State& state) { run_tetgen(state, input); });
  }
  if (!bench::run_benchmarks(arguments, 5)) return 2;
  print_table(cases);
  return 0;
}

}  // namespace
}  // namespace cocoon

int main(int argc, char** argv) { return cocoon::run(argc, argv); }
