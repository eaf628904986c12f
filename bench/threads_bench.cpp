// How the Delaunay kernel scales with threads.
//
//   threads_bench [--points N] [--sets NAME[,NAME...]] [--threads T[,T...]] [--repetitions R]
//
// For each set: R repetitions of a build with each number of threads, interleaved; the cells are
// those of one thread, or the program stops. Prints the best wall-clock time of each, the processor
// time of that run, and the counters: points put off because another thread was at work there, runs
// of points that changed hands, and cells created beyond those of one thread. The counters mean
// something also with more threads than cores.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include "bench/stopwatch.h"
#include "delaunay/delaunay.h"
#include "ref/cell_set.h"
#include "tests/gallery.h"

namespace cocoon {
namespace {

struct Arguments {
  std::size_t points = 1000000;
  std::vector<std::string> sets{"uniform", "torus", "bumpy_sphere"};
  std::vector<std::string> threads{"1", "2", "4", "8", "16"};
  int repetitions = 3;
};

std::vector<std::string> split(const std::string& list) {
  std::vector<std::string> parts;
  std::istringstream stream(list);
  for (std::string part; std::getline(stream, part, ',');) parts.push_back(part);
  return parts;
}

Arguments parse_arguments(int argc, char** argv) {
  Arguments arguments;
  for (int i = 1; i + 1 < argc; i += 2) {
    const std::string name = argv[i];
    const std::string value = argv[i + 1];
    if (name == "--points") arguments.points = std::strtoull(value.c_str(), nullptr, 10);
    if (name == "--sets") arguments.sets = split(value);
    if (name == "--threads") arguments.threads = split(value);
    if (name == "--repetitions") arguments.repetitions = std::max(1, std::atoi(value.c_str()));
  }
  return arguments;
}

// Empty for a name that does not exist.
std::vector<Point> make_set(const std::string& name, std::size_t count) {
  if (name == "uniform") return gallery::uniform_cube(count);
  if (name == "torus") return gallery::displaced_torus(count);
  if (name == "bumpy_sphere") return gallery::bumpy_sphere(count);
  if (name == "sphere") return gallery::sphere(count);
  return {};
}

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
  const Row& one = rows.front();
  const auto n = static_cast<double>(points);
  const auto created = static_cast<double>(one.counters.cells_created);
  for (const Row& row : rows) {
    std::printf("%-13s %8zu %7d | %7.0f %7.2f | %9.0f %6.2f | %7zu %7.3f | %6zu %+9.3f\n",
                set.c_str(), points, row.threads, row.best.wall * 1e9 / n,
                one.best.wall / row.best.wall, row.best.processor * 1e9 / n,
                row.best.processor / one.best.processor, row.counters.retries,
                100 * static_cast<double>(row.counters.retries) / n, row.counters.stolen_runs,
                100 * (static_cast<double>(row.counters.cells_created) / created - 1));
  }
}

int run(const Arguments& arguments) {
  std::printf("%-13s %8s %7s | %15s | %16s | %15s | %6s %9s\n", "set", "points", "threads",
              "wall ns/pt  x", "processor  cost", "put off      %", "stolen", "cells + %");
  for (const std::string& set : arguments.sets) {
    const std::vector<Point> points = make_set(set, arguments.points);
    if (points.size() < 4) {
      std::fprintf(stderr, "threads_bench: no set '%s'\n", set.c_str());
      return 2;
    }
    const std::uint64_t expected = ref::cell_set_hash(delaunay(points).triangulation);
    std::vector<Row> rows;
    for (const std::string& threads : arguments.threads)
      rows.emplace_back().threads = std::stoi(threads);
    for (int repetition = 0; repetition < arguments.repetitions; ++repetition) {
      for (Row& row : rows) measure(points, expected, row);
    }
    print(set, points.size(), rows);
  }
  return 0;
}

}  // namespace
}  // namespace cocoon

int main(int argc, char** argv) { return cocoon::run(cocoon::parse_arguments(argc, argv)); }
