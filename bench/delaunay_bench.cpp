// The Delaunay kernel beside CGAL's and TetGen's, on the point sets of tests/gallery.h.
//
//   delaunay_bench [--points N[,N...]] [--sets NAME[,NAME...]] [--threads N] [--benchmark_...]
//
// Every set is first triangulated by all three and the cells compared; if they differ the program
// stops with exit code 1 (TetGen's only where no points are cospherical: it breaks such ties in its
// own way). Then repetitions of all run in random alternation, so that whatever else the machine
// does hits all alike, and a table gives medians and their ratios. A repetition with another number
// of cells than the first makes the exit code 1, too.
#include <algorithm>
#include <benchmark/benchmark.h>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "bench/options.h"
#include "bench/point_sets.h"
#include "bench/rivals/cgal.h"
#include "bench/rivals/tetgen.h"
#include "bench/run_benchmarks.h"
#include "bench/stopwatch.h"
#include "bench/tidy_heap.h"
#include "delaunay/delaunay.h"
#include "ref/cell_set.h"
#include "ref/cgal_delaunay.h"

namespace cocoon {
namespace {

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

// The rival whose cells are not ours; "" if there is none.
std::string differing_rival(Case& input, const Execution& execution) {
  const Triangulation ours = delaunay(input.points, {}, execution).triangulation;
  input.finite_cells = ours.num_finite_cells();
  const std::uint64_t cells = ref::cell_set_hash(ours);
  if (ref::cell_set_hash(ref::cgal_delaunay(input.points)) != cells) return "CGAL";
  if (!has_ties(input) && rivals::tetgen_cell_set_hash(input.points) != cells) return "TetGen";
  return "";
}

void run_ours(benchmark::State& state, Case& input, const Execution& execution) {
  for ([[maybe_unused]] auto _ : state) {
    bench::tidy_heap();
    const bench::Stopwatch stopwatch;
    const DelaunayResult result = delaunay(input.points, {}, execution);
    const bench::Elapsed elapsed = stopwatch.elapsed();
    if (result.triangulation.num_finite_cells() != input.finite_cells) {
      bench::fail(state, "cocoon: wrong number of cells on " + input.name);
    }
    state.SetIterationTime(elapsed.wall);
    input.ours.push_back(elapsed);
  }
  state.counters["points"] = static_cast<double>(input.points.size());
}

void run_cgal(benchmark::State& state, Case& input) {
  for ([[maybe_unused]] auto _ : state) {
    bench::tidy_heap();
    const rivals::TimedBuild build = rivals::cgal_delaunay(input.points);
    if (build.finite_cells != input.finite_cells) {
      bench::fail(state, "CGAL: wrong number of cells on " + input.name);
    }
    state.SetIterationTime(build.elapsed.wall);
    input.cgal.push_back(build.elapsed);
  }
  state.counters["points"] = static_cast<double>(input.points.size());
}

void run_tetgen(benchmark::State& state, Case& input) {
  for ([[maybe_unused]] auto _ : state) {
    bench::tidy_heap();
    const rivals::TimedBuild build = rivals::tetgen_delaunay(input.points);
    if (build.finite_cells != input.finite_cells && !has_ties(input)) {
      bench::fail(state, "TetGen: wrong number of cells on " + input.name);
    }
    state.SetIterationTime(build.elapsed.wall);
    input.tetgen.push_back(build.elapsed);
  }
  state.counters["points"] = static_cast<double>(input.points.size());
}

double nanoseconds(const std::vector<bench::Elapsed>& runs, double bench::Elapsed::*time,
                   std::size_t points) {
  return bench::median(runs, time) * 1e9 / static_cast<double>(points);
}

// The widest deviation of a run of any kernel from its median, in processor time, percent.
double spread(const Case& input) {
  double widest = 0;
  for (const auto* runs : {&input.ours, &input.cgal, &input.tetgen}) {
    if (runs->empty()) continue;
    const double middle = bench::median(*runs, &bench::Elapsed::processor);
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
      const double ours = nanoseconds(input.ours, time, input.points.size());
      const double cgal = nanoseconds(input.cgal, time, input.points.size());
      const double tetgen = nanoseconds(input.tetgen, time, input.points.size());
      std::printf(" | %6.0f %6.0f %5.2f %7.0f %5.2f", ours, cgal, cgal / ours, tetgen,
                  tetgen / ours);
    }
    std::printf(" | %4.0f %%\n", spread(input));
  }
}

// Makes the inputs of all sets and sizes; stops the program if the kernels disagree.
std::vector<Case> make_cases(const bench::Options& options, const std::vector<std::string>& sets,
                             const std::vector<std::string>& sizes, const Execution& execution) {
  std::vector<Case> cases;
  for (const std::string& set : sets) {
    for (const std::string& size : sizes) {
      Case input{set, bench::point_set(set, options.as_number(size)), 0, {}, {}, {}};
      if (input.points.size() < 4) {
        options.fail(std::string("no set '").append(set).append("' of ").append(size));
      }
      if (const std::string rival = differing_rival(input, execution); !rival.empty()) {
        std::fprintf(stderr, "delaunay_bench: cells differ from those of %s on %s %s\n",
                     rival.c_str(), set.c_str(), size.c_str());
        std::exit(1);
      }
      cases.push_back(std::move(input));
    }
  }
  return cases;
}

int run(int argc, char** argv) {
  bench::Options options(argc, argv);
  const std::vector<std::string> sizes = options.list("--points", "100000");
  const std::vector<std::string> sets =
      options.list("--sets", "uniform,torus,bumpy_sphere,exact_torus,grid,sphere,box");
  const Execution execution{.threads = static_cast<int>(options.number("--threads", 1))};
  std::vector<Case> cases = make_cases(options, sets, sizes, execution);
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
  const int exit_code = bench::run_benchmarks(options, 5);
  print_table(cases);
  return exit_code;
}

}  // namespace
}  // namespace cocoon

int main(int argc, char** argv) { return cocoon::run(argc, argv); }
