// Time and memory per point as inputs grow: uniform in a cube, scanned from a surface, and a grid
// (all cells cospherical). Each line is measured in a process of its own, so that its peak memory
// is its own; it holds the input as well.
//
//   load_bench [LARGEST [THREADS]]     sizes 10^4, 10^5, ... up to LARGEST (10^6), and LARGEST
#include <array>
#include <cstdio>
#include <filesystem>
#include <string>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

#include "bench/options.h"
#include "bench/point_sets.h"
#include "bench/stopwatch.h"
#include "cocone/reconstruct.h"
#include "delaunay/delaunay.h"
#include "geom/mesh_check.h"
#include "io/mesh_file.h"
#include "update/update_model.h"

namespace cocoon::bench {
namespace {

struct Shape {
  const char* name;
  const char* set;  // of point_sets.h
};

constexpr std::array<Shape, 3> shapes = {
    {{"uniform", "uniform"}, {"scan", "bumpy_sphere"}, {"grid", "grid"}}};

struct Measured {
  std::size_t points = 0;
  Elapsed elapsed;
  bool right = false;
  long peak_kilobytes = 0;  // of the process that measured
};

Measured measure_delaunay(const std::vector<Point>& points, int threads) {
  const Stopwatch stopwatch;
  const DelaunayResult result = delaunay(points, {}, {.threads = threads});
  const Elapsed elapsed = stopwatch.elapsed();
  return {points.size(), elapsed, result.triangulation.num_vertices() == points.size()};
}

Measured measure_mode(const std::vector<Point>& points, int threads, Mode mode) {
  const Stopwatch stopwatch;
  const ReconstructResult result = reconstruct_tight(points, {.mode = mode}, {.threads = threads});
  const Elapsed elapsed = stopwatch.elapsed();
  return {points.size(), elapsed,
          result.status != SurfaceStatus::ok || mesh_check(result.mesh).balanced};
}

Measured measure_reconstruct(const std::vector<Point>& points, int threads) {
  return measure_mode(points, threads, Mode::robust);
}
Measured measure_paper_mode(const std::vector<Point>& points, int threads) {
  return measure_mode(points, threads, Mode::paper);
}

// Runs `body` in a process of its own.
template <class Body>
int run_apart(const Body& body) {
  std::fflush(stdout);
  const pid_t child = fork();
  if (child == 0) _exit(body() ? 0 : 1);
  int status = -1;
  waitpid(child, &status, 0);
  return status;
}

// A cap of the scanned body, a twentieth of its points, raised in the middle, onto a model that
// another process reconstructs and leaves in a file.
Measured measure_update(const std::vector<Point>& points, int threads) {
  const std::filesystem::path file =
      std::filesystem::temp_directory_path() / ("load_bench." + std::to_string(getpid()) + ".ply");
  run_apart([&] {
    write_mesh(file, reconstruct_tight(points, {}, {.threads = threads}).mesh);
    return true;
  });
  const TriangleMesh model = read_mesh(file);
  std::filesystem::remove(file);
  std::vector<Point> cap;
  for (const Point& p : point_set("bumpy_sphere", points.size() + 1)) {
    const double height = unit(p).z - 0.9;
    if (height > 0) cap.push_back((1 + 4 * height * height) * p);
  }
  const Stopwatch stopwatch;
  const UpdateResult result =
      update_model(model, std::vector<std::vector<Point>>{cap}, {}, {.threads = threads});
  const Elapsed elapsed = stopwatch.elapsed();
  if (result.status != UpdateStatus::ok) std::printf("%s\n", result.message.c_str());
  return {points.size() + cap.size(), elapsed, result.status == UpdateStatus::ok};
}

struct Work {
  const char* name;
  Measured (*measure)(const std::vector<Point>& points, int threads);
  bool of_volumes;  // points that fill space, too; they have no surface to update
};

constexpr std::array<Work, 4> works = {{{"delaunay", measure_delaunay, true},
                                        {"reconstruct", measure_reconstruct, true},
                                        {"reconstruct, paper mode", measure_paper_mode, true},
                                        {"update", measure_update, false}}};

// Measures in a child process and prints one line; false if that failed.
bool measure(const Shape& shape, const Work& work, std::size_t count, int threads) {
  int pipe_ends[2];
  if (pipe(pipe_ends) != 0) return false;
  const int status = run_apart([&] {
    Measured measured = work.measure(point_set(shape.set, count), threads);
    // Not what the parent is told: that has the peak of the child's own children in it.
    rusage own = {};
    getrusage(RUSAGE_SELF, &own);
    measured.peak_kilobytes = own.ru_maxrss;
    return write(pipe_ends[1], &measured, sizeof measured) == static_cast<ssize_t>(sizeof measured);
  });
  close(pipe_ends[1]);
  Measured measured;
  const ssize_t got = read(pipe_ends[0], &measured, sizeof measured);
  close(pipe_ends[0]);
  const bool done = got == static_cast<ssize_t>(sizeof measured) && measured.right;
  if (!done) {
    std::printf("| %s | %zu | %s | failed (status %d) |\n", shape.name, count, work.name, status);
    return false;
  }
  const double n = static_cast<double>(measured.points);
  std::printf("| %s | %zu | %s | %.2f | %.2f | %.2f | %.0f |\n", shape.name, measured.points,
              work.name, measured.elapsed.wall, measured.elapsed.processor,
              1e6 * measured.elapsed.processor / n,
              1024 * static_cast<double>(measured.peak_kilobytes) / n);
  std::fflush(stdout);
  return true;
}

}  // namespace
}  // namespace cocoon::bench

int main(int argc, char** argv) {
  using namespace cocoon::bench;
  const Options options(argc, argv);
  const std::vector<std::string>& given = options.rest();
  if (given.size() > 2) options.fail("takes two numbers at most");
  const std::size_t largest = given.empty() ? 1000000 : options.as_number(given[0]);
  const int threads = given.size() < 2 ? 1 : static_cast<int>(options.as_number(given[1]));
  std::vector<std::size_t> sizes;
  for (std::size_t size = 10000; size < largest; size *= 10) sizes.push_back(size);
  sizes.push_back(largest);
  std::printf(
      "| points | number | work | s | processor s | us per point | peak bytes per point |\n"
      "| --- | --- | --- | --- | --- | --- | --- |\n");
  bool all = true;
  for (const std::size_t size : sizes) {
    for (const Shape& shape : shapes) {
      for (const Work& work : works) {
        if (!work.of_volumes && std::string(shape.name) != "scan") continue;
        all = measure(shape, work, size, threads) && all;
      }
    }
  }
  return all ? 0 : 1;
}
