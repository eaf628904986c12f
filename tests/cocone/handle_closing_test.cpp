#include "cocone/handle_closing.h"

#include <gtest/gtest.h>
#include <vector>

#include "cocone/handle_loops.h"
#include "tests/cocone/random_labeling.h"

namespace cocoon {
namespace {

// Nothing is flipped where the other costs would grow too much; where cells are, the energy from
// its definition falls by all of a handle but that, and handles go.
TEST(HandleClosing, ClosesHandlesThatCostLittle) {
  std::size_t closed = 0;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    Labeling labeling(shapes::random_cube(60, seed), seed, 0.15);
    const DoubtfulRegion region = whole(labeling);
    const Triangulation& t = labeling.stages.triangulation;
    HandleLoops loops(t, labeling.stars, labeling.out);
    HandleClosing closing(t, labeling.stars, labeling.cosines, region, labeling.out,
                          labeling.energy, labeling.options);
    for (const Triangle& loop : loops.find(region)) {
      if (!loops.is_handle(loop, 100000)) continue;
      EXPECT_GE(closing.count_cells_at(loop), labeling.stars.cells_at(loop).size());
      for (const std::uint8_t side : {std::uint8_t{0}, std::uint8_t{1}}) {
        const auto before = labeling.out;
        const std::vector<CellId> cells = closing.find(loop, side);
        EXPECT_TRUE(labeling.out == before);
        if (cells.empty()) continue;
        const Energy total = labeling.total();
        const std::ptrdiff_t chi = labeling.euler();
        for (const CellId c : cells) EXPECT_EQ(labeling.out[c], side);
        labeling.energy.flip(cells);
        const double most = labeling.options.max_closing_rise - labeling.options.handle_cost;
        EXPECT_LE(labeling.total() - total, to_energy(most));
        closed += labeling.euler() > chi ? 1U : 0U;
        break;
      }
    }
  }
  EXPECT_GT(closed, 5U);
}

}  // namespace
}  // namespace cocoon
