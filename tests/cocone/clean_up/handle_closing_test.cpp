#include "cocone/clean_up/handle_closing.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <span>
#include <vector>

#include "cocone/clean_up/best_move.h"
#include "cocone/clean_up/handle_loops.h"
#include "cocone/facets/cell_order.h"
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

// The definition: every flip is that of the cell with the least change of the total energy.
class PlainClosing {
 public:
  PlainClosing(Labeling& labeling, const DoubtfulRegion& region)
      : labeling_(labeling), t_(labeling.stages.triangulation), region_(region) {}

  std::vector<CellId> find(const Triangle& loop, std::uint8_t side) {
    const IdVector<CellId, std::uint8_t> before = labeling_.out;
    const CleanUpOptions& options = labeling_.options;
    const Energy start = labeling_.total();
    Energy highest = 0;
    Energy lowest = 0;
    std::vector<CellId> flips;
    std::vector<CellId> best;
    std::vector<CellId> window = window_at(loop, side);
    while (!window.empty()) {
      const CellId next = least(window);
      if (next.is_none()) break;
      flip(next);
      const Energy change = labeling_.total() - start;
      flip(next);
      if (change > to_energy(options.max_rise)) break;
      flip(next);
      flips.push_back(next);
      std::erase(window, next);
      highest = std::max(highest, change);
      if (highest - change < to_energy(options.handle_cost)) continue;
      if (!best.empty() && change >= lowest) continue;
      lowest = change;
      best = flips;
    }
    for (std::size_t k = best.size(); k < flips.size(); ++k) flip(flips[k]);
    go_back(best);
    const Energy change = labeling_.total() - start;
    const bool pays =
        change < 0 &&
        change <= to_energy(options.max_closing_rise) - to_energy(options.handle_cost) &&
        hang_on(best);
    for (const CellId c : best) flip(c);
    EXPECT_TRUE(labeling_.out == before);
    return pays ? best : std::vector<CellId>{};
  }

 private:
  void flip(CellId c) { labeling_.out[c] ^= 1; }

  // Asked for after each flip: attached ones of which none changes the energy less.
  CellId least(const std::vector<CellId>& window) {
    CellId best;
    Energy least = 0;
    for (const CellId c : window) {
      if (!is_attached(t_, labeling_.out, {&c, 1})) continue;
      flip(c);
      const Energy total = labeling_.total();
      flip(c);
      if (best.is_none() || total < least ||
          (total == least && sorted_corners(t_, c) < sorted_corners(t_, best))) {
        best = c;
        least = total;
      }
    }
    return best;
  }

  std::vector<CellId> window_at(const Triangle& loop, std::uint8_t side) {
    std::vector<CellId> window;
    for (const CellId c : t_.finite_cells()) {
      const auto& vertices = t_.cell(c).vertices;
      const bool at_loop = std::any_of(vertices.begin(), vertices.end(), [&](VertexId v) {
        return std::find(loop.begin(), loop.end(), v) != loop.end();
      });
      const bool is_left = std::any_of(vertices.begin(), vertices.end(),
                                       [&](VertexId v) { return region_.is_left(v); });
      if (at_loop && !is_left && labeling_.out[c] == side && !labeling_.cosines.is_flat(c)) {
        window.push_back(c);
      }
    }
    return window;
  }

  // Flips that lower the energy by going back alone, from the last one on, as long as there are.
  void go_back(std::vector<CellId>& flips) {
    for (bool any = true; any;) {
      any = false;
      for (std::size_t k = flips.size(); k > 0; --k) {
        const CellId c = flips[k - 1];
        if (!is_attached(t_, labeling_.out, {&c, 1})) continue;
        const Energy before = labeling_.total();
        flip(c);
        if (labeling_.total() < before) {
          std::erase(flips, c);
          any = true;
        } else {
          flip(c);
        }
      }
    }
  }

  // From each of them, through others of them, to a cell on their side that stays.
  bool hang_on(const std::vector<CellId>& cells) const {
    std::vector<CellId> held;
    for (std::size_t before = cells.size() + 1; before != held.size();) {
      before = held.size();
      for (const CellId c : cells) {
        if (std::find(held.begin(), held.end(), c) != held.end()) continue;
        for (int i = 0; i < 4; ++i) {
          const CellId behind = t_.neighbor(c, i);
          const bool goes = std::find(cells.begin(), cells.end(), behind) != cells.end() &&
                            std::find(held.begin(), held.end(), behind) == held.end();
          if (goes || labeling_.out[behind] != labeling_.out[c]) continue;
          held.push_back(c);
          break;
        }
      }
    }
    return held.size() == cells.size();
  }

  Labeling& labeling_;
  const Triangulation& t_;
  const DoubtfulRegion& region_;
};

// On random cells, and on a lattice with its ties and flat cells; with vertices that are left
// alone; where little or much may be paid.
TEST(HandleClosing, IsItsDefinition) {
  std::size_t found = 0;
  for (std::uint64_t seed = 1; seed <= 16; ++seed) {
    const bool is_lattice = seed % 2 == 0;
    Labeling labeling(is_lattice ? gallery::integer_grid(3) : shapes::random_cube(20, seed), seed,
                      seed % 4 < 2 ? 0.15 : 0.4);
    const double handle_cost = labeling.options.handle_cost;
    if (seed % 3 != 0) labeling.options.max_closing_rise = handle_cost;
    if (seed % 3 == 1) labeling.options.max_rise = 1;
    DoubtfulRegion region = whole(labeling);
    const Triangulation& t = labeling.stages.triangulation;
    for (const CellId c : t.finite_cells()) {
      if (is_lattice) labeling.energy.set_preference(c, 0);
    }
    if (seed > 8) {
      region.left = VertexSet(t.num_vertices(), 0);
      region.left[VertexId(std::size_t{seed})] = 1;
      region.left_cells = 1;
    }
    HandleLoops loops(t, labeling.stars, labeling.out);
    HandleClosing closing(t, labeling.stars, labeling.cosines, region, labeling.out,
                          labeling.energy, labeling.options);
    PlainClosing plain(labeling, region);
    std::size_t asked = 0;
    for (const Triangle& loop : loops.find(region)) {
      if (++asked > 5) break;
      for (const std::uint8_t side : {std::uint8_t{0}, std::uint8_t{1}}) {
        const std::vector<CellId> expected = plain.find(loop, side);
        EXPECT_EQ(closing.find(loop, side), expected) << "seed " << seed;
        found += expected.empty() ? 0U : 1U;
      }
    }
  }
  EXPECT_GT(found, 10U);
}

}  // namespace
}  // namespace cocoon
