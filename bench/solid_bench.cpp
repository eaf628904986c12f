// A CAD mesh that is made dense: how far cells lie in and out of it, beside CGAL's answer, and what
// it saves to remember that.
//
//   solid_bench [--spacing LENGTH] [--benchmark_...]
//
// The part is tests/data/models/fixed_top.ply, sampled about LENGTH apart (0.6). Distances: of the
// centroids of all cells between the samples; search trees are built within the clock, by both.
// Before they are timed those of both are compared. Making dense: labels of the cells, samples that
// conform, labels of their cells, as --densify asks for them, with a triangulation for each and
// those of the rounds; after each repetition the number of samples added is compared.
// Medians of 3 repetitions in random alternation; one thread. A wrong result makes the exit code 1.
#include <benchmark/benchmark.h>
#include <cmath>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "bench/options.h"
#include "bench/rivals/cgal_signed_distances.h"
#include "bench/run_benchmarks.h"
#include "cocone/solid/conforming_samples.h"
#include "cocone/solid/labels_of_solid.h"
#include "cocone/solid/solid_distances.h"
#include "delaunay/delaunay.h"
#include "geom/mesh/dense_samples.h"
#include "geom/signed_distance.h"
#include "io/mesh_file.h"

namespace cocoon {
namespace {

const Execution one_thread = {.threads = 1};

std::vector<Point> joined(std::vector<Point> points, const std::vector<Point>& more) {
  points.insert(points.end(), more.begin(), more.end());
  return points;
}

struct Part {
  explicit Part(double sample_spacing)
      : mesh(read_mesh(std::string(COCOON_TEST_DATA) + "/models/fixed_top.ply")),
        spacing(sample_spacing),
        samples(joined(mesh.points.raw(), dense_samples(mesh, {.spacing = spacing}))) {
    const Triangulation triangulation = delaunay(samples).triangulation;
    for (const CellId c : triangulation.finite_cells()) {
      const auto& [p, q, r, s] = triangulation.cell(c).vertices;
      places.push_back(0.25 * ((triangulation.point(p) + triangulation.point(q)) +
                               (triangulation.point(r) + triangulation.point(s))));
    }
    distances = signed_distances(mesh, places, one_thread);
  }
  TriangleMesh mesh;
  double spacing;
  std::vector<Point> samples;
  std::vector<Point> places;
  std::vector<double> distances;  // of the places
};

bool agree(const std::vector<double>& a, const std::vector<double>& b) {
  constexpr double rounding = 1e-9;
  for (std::size_t k = 0; k < a.size(); ++k) {
    if (!(std::abs(a[k] - b[k]) <= rounding)) return false;
  }
  return a.size() == b.size();
}

template <class Distances>
void run_distances(benchmark::State& state, const Part& part, const Distances& distances) {
  if (!agree(distances(), part.distances)) bench::fail(state, "another distance");
  for (auto _ : state) benchmark::DoNotOptimize(distances());
  state.counters["places"] = static_cast<double>(part.places.size());
}

std::size_t make_dense(const Part& part, const SolidDistances& solid) {
  const auto labels_of = [&](const std::vector<Point>& samples,
                             const LabelsOfSolidOptions& options) {
    labels_of_solid(delaunay(samples, {}, one_thread).triangulation, solid, options, one_thread);
  };
  labels_of(part.samples, labels_of_crossing_cells);
  const std::vector<Point> added =
      conforming_samples(solid, part.samples, {.spacing = part.spacing}, one_thread).added;
  labels_of(joined(part.samples, added), {});
  return added.size();
}

template <class MakeSolid>
void run_dense(benchmark::State& state, const Part& part, std::size_t expected,
               const MakeSolid& make_solid) {
  for (auto _ : state) {
    if (make_dense(part, make_solid()) != expected) bench::fail(state, "other samples");
  }
  state.counters["added"] = static_cast<double>(expected);
}

// `added`: the samples that make the part dense.
void register_all(const Part& part, std::size_t added) {
  const auto add = [](const char* name, auto run) {
    benchmark::RegisterBenchmark(name, run)->Unit(benchmark::kMillisecond);
  };
  add("distances/cocoon", [&](benchmark::State& state) {
    run_distances(state, part,
                  [&] { return signed_distances(part.mesh, part.places, one_thread); });
  });
  add("distances/cgal", [&](benchmark::State& state) {
    run_distances(state, part,
                  [&] { return rivals::cgal_signed_distances(part.mesh, part.places); });
  });
  add("made_dense/remembered", [&](benchmark::State& state) {
    run_dense(state, part, added,
              [&] { return SolidDistances(std::make_shared<const TriangleMesh>(part.mesh)); });
  });
  add("made_dense/asked_again", [&](benchmark::State& state) {
    run_dense(state, part, added, [&] { return SolidDistances(part.mesh); });
  });
}

}  // namespace
}  // namespace cocoon

int main(int argc, char** argv) {
  using namespace cocoon;
  bench::Options options(argc, argv);
  const Part part(std::stod(options.text("--spacing", "0.6")));
  register_all(part, make_dense(part, part.mesh));
  return bench::run_benchmarks(options, 3);
}
