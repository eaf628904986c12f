#include "cocone/clean_up/vertex_repairs.h"

#include <gtest/gtest.h>
#include <vector>

#include "tests/cocone/peeled.h"
#include "tests/cocone/sample_shapes.h"

namespace cocoon {
namespace {

TEST(VertexRepairs, GoOnUntilNoMoveHelps) {
  Peeled peeled(shapes::noisy_sphere(600, 0.05, 3));
  VertexRepairs repairs(peeled.labels, peeled.options, {});
  const std::size_t flawed = peeled.labels.flawed_vertices().size();
  CleanUpCounters counters;
  repairs.move(counters);
  EXPECT_GT(counters.moves, 10U);
  EXPECT_GE(counters.moved_cells, counters.moves);
  EXPECT_LT(peeled.labels.flawed_vertices().size(), flawed);
  CleanUpCounters again;
  repairs.move(again);
  EXPECT_EQ(again.moves, 0U);
}

TEST(VertexRepairs, CompoundMovesMayBeSwitchedOff) {
  std::size_t made = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    for (const double max_rise : {0.0, CleanUpOptions().max_rise}) {
      CleanUpOptions options;
      options.max_rise = max_rise;
      Peeled peeled(shapes::noisy_sphere(600, 0.05, seed), options);
      VertexRepairs repairs(peeled.labels, peeled.options, {});
      CleanUpCounters counters;
      repairs.move(counters);
      const bool changed = repairs.make_compound_moves(counters);
      EXPECT_EQ(changed, counters.compound_moves != 0);
      EXPECT_TRUE(max_rise != 0 || counters.compound_moves == 0);
      made += counters.compound_moves;
    }
  }
  EXPECT_GT(made, 0U);
}

}  // namespace
}  // namespace cocoon
