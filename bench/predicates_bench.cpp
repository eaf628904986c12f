// The exact predicates: what a call costs when the filter decides, and when integers must.
#include <array>
#include <benchmark/benchmark.h>
#include <cstddef>
#include <vector>

#include "geom/predicate_levels.h"
#include "tests/geom/near_degenerate.h"

namespace cocoon {
namespace {

using test::Family;
using Sample = std::array<Point, 5>;

// Varied inputs, so that branch predictors learn nothing; few enough to stay in the cache.
std::vector<Sample> samples(Family family) {
  test::NearDegenerate random(1);
  std::vector<Sample> result;
  for (int i = 0; i < 256; ++i) result.push_back(random.points(family));
  return result;
}

template <class Predicate>
void run(benchmark::State& state, Family family, const Predicate& predicate) {
  const std::vector<Sample> inputs = samples(family);
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(predicate(inputs[i++ % inputs.size()]));
}

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

BENCHMARK_CAPTURE(run, orient3d_filter, Family::random, orientation);
BENCHMARK_CAPTURE(run, orient3d_grid, Family::grid, orientation);
BENCHMARK_CAPTURE(run, orient3d_coplanar, Family::coplanar, orientation);
BENCHMARK_CAPTURE(run, orient3d_wide, Family::mixed, orientation_at(PredicateLevel::wide));
BENCHMARK_CAPTURE(run, insphere_filter, Family::random, sphere);
BENCHMARK_CAPTURE(run, insphere_grid, Family::grid, sphere);
BENCHMARK_CAPTURE(run, insphere_cospherical, Family::cospherical, sphere);
BENCHMARK_CAPTURE(run, insphere_grid_64, Family::grid, sphere_at(PredicateLevel::grid_64));
BENCHMARK_CAPTURE(run, insphere_grid_128, Family::cospherical, sphere_at(PredicateLevel::grid_128));
BENCHMARK_CAPTURE(run, insphere_grid_256, Family::cospherical, sphere_at(PredicateLevel::grid_256));
BENCHMARK_CAPTURE(run, insphere_wide, Family::mixed, sphere_at(PredicateLevel::wide));

}  // namespace
}  // namespace cocoon

BENCHMARK_MAIN();
