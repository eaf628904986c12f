// The exact predicates: what a call costs when the filter decides, and when integers must.
//
//   predicates_bench [--benchmark_...]
//
// All signs are first compared with those of rational numbers; if one differs the exit code is 1.
// Medians of 5 repetitions in random alternation.
#include <array>
#include <benchmark/benchmark.h>
#include <cstddef>
#include <vector>

#include "bench/options.h"
#include "bench/run_benchmarks.h"
#include "geom/exact/predicate_levels.h"
#include "ref/rational_predicates.h"
#include "tests/geom/near_degenerate.h"

namespace cocoon {
namespace {

using test::Family;
using Sample = std::array<Point, 5>;

// Varied inputs, so that branch predictors learn nothing; few enough to stay in the cache. A power
// of two, so that to take the next one costs no division.
constexpr std::size_t num_samples = 256;
std::vector<Sample> samples(Family family) {
  test::NearDegenerate random(1);
  std::vector<Sample> result;
  for (std::size_t i = 0; i < num_samples; ++i) result.push_back(random.points(family));
  return result;
}

template <class Predicate>
void run(benchmark::State& state, Family family, Sign (*exact)(const Sample&),
         const Predicate& predicate) {
  const std::vector<Sample> inputs = samples(family);
  for (const Sample& p : inputs) {
    if (predicate(p) == exact(p)) continue;
    bench::fail(state, "wrong sign");
    return;
  }
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(predicate(inputs[i++ % num_samples]));
}

Sign exact_orientation(const Sample& p) { return ref::orient3d(p[0], p[1], p[2], p[3]); }
Sign exact_sphere(const Sample& p) { return ref::insphere(p[0], p[1], p[2], p[3], p[4]); }

const auto orientation = [](const Sample& p) { return orient3d(p[0], p[1], p[2], p[3]); };
const auto sphere = [](const Sample& p) { return insphere(p[0], p[1], p[2], p[3], p[4]); };
const auto sphere_at = [](PredicateLevel level) {
  return [level](const Sample& p) {
    return insphere_on_grid(p[0], p[1], p[2], p[3], p[4], level).sign;
  };
};
const auto orientation_at = [](PredicateLevel level) {
  return [level](const Sample& p) { return orient3d_on_grid(p[0], p[1], p[2], p[3], level).sign; };
};

BENCHMARK_CAPTURE(run, orient3d_filter, Family::random, exact_orientation, orientation);
BENCHMARK_CAPTURE(run, orient3d_grid, Family::grid, exact_orientation, orientation);
BENCHMARK_CAPTURE(run, orient3d_coplanar, Family::coplanar, exact_orientation, orientation);
BENCHMARK_CAPTURE(run, orient3d_wide, Family::mixed, exact_orientation,
                  orientation_at(PredicateLevel::wide));
BENCHMARK_CAPTURE(run, insphere_filter, Family::random, exact_sphere, sphere);
BENCHMARK_CAPTURE(run, insphere_grid, Family::grid, exact_sphere, sphere);
BENCHMARK_CAPTURE(run, insphere_cospherical, Family::cospherical, exact_sphere, sphere);
BENCHMARK_CAPTURE(run, insphere_grid_64, Family::grid, exact_sphere,
                  sphere_at(PredicateLevel::grid_64));
BENCHMARK_CAPTURE(run, insphere_grid_128, Family::cospherical, exact_sphere,
                  sphere_at(PredicateLevel::grid_128));
BENCHMARK_CAPTURE(run, insphere_grid_256, Family::cospherical, exact_sphere,
                  sphere_at(PredicateLevel::grid_256));
BENCHMARK_CAPTURE(run, insphere_grid_512, Family::cospherical, exact_sphere,
                  sphere_at(PredicateLevel::grid_512));
BENCHMARK_CAPTURE(run, insphere_wide, Family::mixed, exact_sphere, sphere_at(PredicateLevel::wide));

}  // namespace
}  // namespace cocoon

int main(int argc, char** argv) {
  return cocoon::bench::run_benchmarks(cocoon::bench::Options(argc, argv), 5);
}
