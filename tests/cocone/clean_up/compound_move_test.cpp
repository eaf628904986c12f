#include "cocone/clean_up/compound_move.h"

#include <gtest/gtest.h>
#include <vector>

#include "tests/cocone/random_labeling.h"

namespace cocoon {
namespace {

struct Mover {
  explicit Mover(Labeling& labeling)
      : split(labeling.stages.triangulation, labeling.out),
        single(labeling.stages.triangulation, labeling.stars, labeling.out, labeling.energy, split,
               labeling.far_reach, labeling.options.most_move_cells),
        compound(labeling.stages.triangulation, labeling.spacings, region, labeling.energy, single,
                 labeling.options) {}
  DoubtfulRegion region;
  LabelSplit split;
  BestMove single;
  CompoundMove compound;
};

// Single moves until none helps anywhere.
void descend(Labeling& labeling, Mover& mover) {
  for (bool changed = true; changed;) {
    changed = false;
    for (const VertexId v : labeling.stages.triangulation.vertices()) {
      if (labeling.energy.vertex_cost(v) == 0) continue;
      const std::vector<CellId> cells = mover.single.find(v);
      if (cells.empty()) continue;
      labeling.energy.flip(cells);
      changed = true;
    }
  }
}

// Where no single move helps, some sequences do; each is made of sets that may change sides, and
// the energy from its definition falls by it.
TEST(CompoundMove, LowersTheEnergyWhereNoSingleMoveDoes) {
  std::size_t found = 0;
  for (const double bias : {0.4, 0.5, 0.6}) {
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
      Labeling labeling(shapes::random_cube(80, seed), seed, bias);
      Mover mover(labeling);
      descend(labeling, mover);
      for (const VertexId v : labeling.stages.triangulation.vertices()) {
        if (labeling.energy.vertex_cost(v) == 0) continue;
        const auto before = labeling.out;
        const std::vector<std::vector<CellId>> moves = mover.compound.find(v);
        EXPECT_TRUE(labeling.out == before);
        if (moves.empty()) continue;
        EXPECT_GE(moves.size(), 2U);
        const Energy total = labeling.total();
        for (const std::vector<CellId>& cells : moves) {
          EXPECT_TRUE(is_attached(labeling.stages.triangulation, labeling.out, cells));
          EXPECT_FALSE(mover.split.splits(cells));
          labeling.energy.flip(cells);
        }
        EXPECT_LT(labeling.total(), total);
        ++found;
        descend(labeling, mover);
      }
    }
  }
  EXPECT_GT(found, 5U);
}

// Neither the limit of the rise nor the number of trials is passed.
TEST(CompoundMove, TriesOnlyWhatItMay) {
  Labeling labeling(shapes::random_cube(120, 5), 3, 0.5);
  labeling.options.max_rise = 0;
  Mover level(labeling);
  labeling.options = {};
  labeling.options.max_openings = 0;
  Mover none(labeling);
  labeling.options = {};
  Mover all(labeling);
  descend(labeling, all);
  std::size_t found = 0;
  for (const VertexId v : labeling.stages.triangulation.vertices()) {
    if (labeling.energy.vertex_cost(v) == 0) continue;
    found += all.compound.find(v).empty() ? 0U : 1U;
    EXPECT_TRUE(level.compound.find(v).empty());
    EXPECT_TRUE(none.compound.find(v).empty());
  }
  EXPECT_GT(found, 0U);
}

}  // namespace
}  // namespace cocoon
