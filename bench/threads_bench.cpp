// How the Delaunay kernel scales with threads.
//
//   threads_bench [--points N] [--sets NAME[,NAME...]] [--threads T[,T...]] [--repetitions R]
//
// For each set: R (3) repetitions of a build with each number of threads, in turn; the cells are
// those of one thread, or the program stops with exit code 1. Prints medians of the wall-clock time
// and of the processor time; how many times as fast each is as the run beside it with the first
// number of threads, median, least and most; the processor time against that of the first; and
// counters of the last run: points put off because another thread was at work there, runs of points
// that changed hands, and cells created beyond those of the first. The counters mean something also
// with more threads than cores.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "bench/options.h"
#include "bench/point_sets.h"
#include "bench/stopwatch.h"
#include "bench/tidy_heap.h"
#include "delaunay/delaunay.h"
#include "geom/arrays/median.h"
#include "ref/cell_set.h"

namespace cocoon {
namespace {

// What was measured with one number of threads.
struct Row {
  int threads = 1;
  std::vector<bench::Elapsed> runs;
  DelaunayCounters counters;  // of the last run
};

void measure(const std::vector<Point>& points, std::uint64_t expected_cells, Row& row) {
  bench::tidy_heap();
  const bench::Stopwatch stopwatch;
  const DelaunayResult result = delaunay(points, {}, {.threads = row.threads});
  row.runs.push_back(stopwatch.elapsed());
  row.counters = result.counters;
  if (ref::cell_set_hash(result.triangulation) != expected_cells) {
    std::fprintf(stderr, "threads_bench: other cells with %d threads\n", row.threads);
    std::exit(1);
  }
}

// How many times as fast as the runs beside them with the first number of threads.
std::vector<double> speed_ups(const Row& row, const Row& first) {
  std::vector<double> ratios;
  for (std::size_t i = 0; i < row.runs.size(); ++i) {
    ratios.push_back(first.runs[i].wall / row.runs[i].wall);
  }
  return ratios;
}

void print(const std::string& set, std::size_t points, const std::vector<Row>& rows) {
  const Row& first = rows.front();
  const auto n = static_cast<double>(points);
  const auto created = static_cast<double>(first.counters.cells_created);
  const double first_cost = bench::median(first.runs, &bench::Elapsed::processor);
  for (const Row& row : rows) {
    const std::vector<double> ratios = speed_ups(row, first);
    const auto [least, most] = std::minmax_element(ratios.begin(), ratios.end());
    const double cost = bench::median(row.runs, &bench::Elapsed::processor);
    std::printf(
        "%-13s %8zu %7d | %7.0f %5.2f %5.2f %5.2f | %9.0f %6.2f | %7zu %7.3f | %6zu %+9.3f\n",
        set.c_str(), points, row.threads, bench::median(row.runs, &bench::Elapsed::wall) * 1e9 / n,
        median(ratios), *least, *most, cost * 1e9 / n, cost / first_cost, row.counters.retries,
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
  std::printf("%-13s %8s %7s | %7s %5s %5s %5s | %16s | %15s | %6s %9s\n", "set", "points",
              "threads", "ns/pt", "x", "from", "to", "processor  cost", "put off      %", "stolen",
              "cells + %");
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
