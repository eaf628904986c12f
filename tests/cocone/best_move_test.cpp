#include "cocone/best_move.h"

#include <algorithm>
#include <array>
#include <gtest/gtest.h>
#include <vector>

#include "cocone/cell_order.h"
#include "delaunay/circulate.h"
#include "tests/cocone/random_labeling.h"

namespace cocoon {
namespace {

// Every set that may be considered at v.
std::vector<std::vector<CellId>> all_moves(Labeling& labeling, VertexId v) {
  const Triangulation& t = labeling.stages.triangulation;
  std::vector<std::vector<CellId>> moves = labeling.energy.parts_of_star(v);
  for (const CellId c : labeling.stages.stars.star(v)) {
    moves.push_back({c});
    for (int i = 0; i < 4; ++i) moves.push_back({c, t.neighbor(c, i)});
  }
  std::erase_if(moves, [&](const std::vector<CellId>& cells) {
    return std::any_of(cells.begin(), cells.end(), [&](CellId c) {
      return t.is_infinite(c) || labeling.out[c] != labeling.out[cells.front()];
    });
  });
  return moves;
}

// The best of them, by evaluating all.
std::vector<CellId> plain_best(Labeling& labeling, SideSplit& split, VertexId v) {
  const Triangulation& t = labeling.stages.triangulation;
  Energy best_change = 0;
  std::vector<CellId> best;
  for (std::vector<CellId>& cells : all_moves(labeling, v)) {
    const Energy change = labeling.energy.change(cells);
    if (change >= 0 || change > best_change || !is_attached(t, labeling.out, cells)) continue;
    if (change == best_change && !precedes(t, cells, best)) continue;
    if (split.splits(cells)) continue;
    best_change = change;
    best = std::move(cells);
  }
  return best;
}

TEST(BestMove, IsTheBestOfAll) {
  std::array<std::size_t, 4> found{};  // by the number of cells
  for (const double bias : {0.1, 0.5, 0.97}) {
    for (const auto& points : {shapes::random_cube(60, 3), lattice(4), ball(4)}) {
      Labeling labeling(points, 11, bias);
      const Triangulation& t = labeling.stages.triangulation;
      SideSplit split(t, labeling.out);
      BestMove best_move(t, labeling.stars, labeling.out, labeling.energy, split);
      for (const VertexId v : t.vertices()) {
        std::vector<CellId> expected = plain_best(labeling, split, v);
        std::vector<CellId> move = best_move.find(v);
        std::sort(expected.begin(), expected.end());
        std::sort(move.begin(), move.end());
        EXPECT_EQ(move, expected);
        ++found[std::min<std::size_t>(move.size(), 3)];
        if (!move.empty()) labeling.energy.flip(move);
      }
    }
  }
  for (const std::size_t count : found) EXPECT_GT(count, 0U);
}

}  // namespace
}  // namespace cocoon
