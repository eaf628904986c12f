// How the Delaunay kernel scales with threads.
//
//   threads_bench [--points N] [--sets NAME[,NAME...]] [--threads T[,T...]] [--repetitions R]
//
// For each set: R repetitions of a build with each number of threads, interleaved; the cells are
// those of one thread, or the program stops with exit code 1. Prints the best wall-clock time of
// each, the processor time of that run, both also against the first number of threads, and the
// counters: points put off because another thread was at work there, runs
// of points that changed hands, and cells created beyond those of the first. The counters mean
// something also with more threads than cores.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <string>
#include <vector>

#include "bench/options.h"
#include "bench/point_sets.h"
#include "bench/stopwatch.h"
#include "delaunay/delaunay.h"
#include "ref/cell_set.h"

namespace cocoon {
namespace {

// What was measured with one number of threads.
struct Row {
  int threads = 1;
  bench::Elapsed best{std::numeric_limits<double>::infinity(), 0};
  DelaunayCounters counters;  // of that run
};

void measure(const std::vector<Point>& points, std::uint64_t expected_cells, Row& row) {
  const bench::Stopwatch stopwatch;
  const DelaunayResult result = delaunay(points, {}, {.threads = row.threads});
  const bench::Elapsed elapsed = stopwatch.elapsed();
  if (elapsed.wall < row.best.wall) {
    row.best = elapsed;
    row.counters = result.counters;
  }
  if (ref::cell_set_hash(result.triangulation) != expected_cells) {
    std::fprintf(stderr, "threads_bench: other cells with %d threads\n", row.threads);
    std::exit(1);
  }
}

void print(const std::string& set, std::size_t points, const std::vector<Row>& rows) {
  const Row& first = rows.front();
  const auto n = static_cast<double>(points);
  const auto created = static_cast<double>(first.counters.cells_created);
  for (const Row& row : rows) {
    std::printf("%-13s %8zu %7d | %7.0f %7.2f | %9.0f %6.2f | %7zu %7.3f | %6zu %+9.3f\n",
                set.c_str(), points, row.threads, row.best.wall * 1e9 / n,
                first.best.wall / row.best.wall, row.best.processor * 1e9 / n,
                row.best.processor / first.best.processor, row.counters.retries,
                100 * static_cast<double>(row.counters.retries) / n, row.counters.stolen_runs,
                100 * (static_cast<double>(row.counters.cells_created) / created - 1));
  }
}

int run(int argc, char** argv) {
  bench::Options options(argc, argv);
  const std::size_t size = options.number("--points", 1000000);
  const std::vector<std::string> sets = options.list("--sets", "uniform,torus,bumpy_sphere");
  const std::vector<std::string> numbers = options.list("--threads", "1,2,4,8,16");
  const std::size_t repetitions = std::max<std::size_t>(1, options.number("--repetitions", 3));
  options.require_no_rest();
  if (numbers.empty()) options.fail("needs a number of threads");
  std::printf("%-13s %8s %7s | %15s | %16s | %15s | %6s %9s\n", "set", "points", "threads",
              "wall ns/pt  x", "processor  cost", "put off      %", "stolen", "cells + %");
  for (const std::string& set : sets) {
    const std::vector<Point> points = bench::point_set(set, size);
    if (points.size() < 4) options.fail("no set '" + set + "' of so many points");
    const std::uint64_t expected = ref::cell_set_hash(delaunay(points).triangulation);
    std::vector<Row> rows;
    for (const std::string& threads : numbers) {
      rows.emplace_back().threads = static_cast<int>(options.as_number(threads));
    }
    for (std::size_t repetition = 0; repetition < repetitions; ++repetition) {
      for (Row& row : rows) measure(points, expected, row);
    }
    print(set, points.size(), rows);
  }
  return 0;
}

}  // namespace
}  // namespace cocoon

int main(int argc, char** argv) { return cocoon::run(argc, argv); }
