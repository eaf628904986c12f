#include "cocone/clean_up/best_move.h"

#include <algorithm>
#include <array>
#include <gtest/gtest.h>
#include <vector>

#include "cocone/facets/cell_order.h"
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

// Would it bring a sample that is near the surface there from afar?
bool reaches_far(Labeling& labeling, const std::vector<CellId>& cells, VertexId v) {
  if (cells.size() > 2 || !labeling.energy.is_unused(v)) return false;
  if (!labeling.far_reach.is_near_surface(v)) return false;
  return std::any_of(cells.begin(), cells.end(),
                     [&](CellId c) { return labeling.far_reach.reaches_far(c, v); });
}

// The best of them, by evaluating all.
std::vector<CellId> plain_best(Labeling& labeling, LabelSplit& split, VertexId v) {
  const Triangulation& t = labeling.stages.triangulation;
  Energy best_change = 0;
  std::vector<CellId> best;
  for (std::vector<CellId>& cells : all_moves(labeling, v)) {
    const Energy change = labeling.energy.change(cells);
    if (change >= 0 || change > best_change || !is_attached(t, labeling.out, cells)) continue;
    if (reaches_far(labeling, cells, v)) continue;
    if (change == best_change && !precedes(t, cells, best)) continue;
    if (split.splits(cells)) continue;
    best_change = change;
    best = std::move(cells);
  }
  return best;
}

// Calls visit(labeling, split, best_move, v) for all vertices of small triangulations.
template <class Visit>
void for_each_vertex(std::array<double, 3> biases, std::uint64_t seed, const Visit& visit) {
  for (const double bias : biases) {
    for (const auto& points : {shapes::random_cube(60, 3), gallery::integer_grid(4), ball(4)}) {
      Labeling labeling(points, seed, bias);
      const Triangulation& t = labeling.stages.triangulation;
      LabelSplit split(t, labeling.out);
      BestMove best_move(t, labeling.stars, labeling.out, labeling.energy, split,
                         labeling.far_reach, labeling.options.most_move_cells);
      for (const VertexId v : t.vertices()) visit(labeling, split, best_move, v);
    }
  }
}

TEST(BestMove, IsTheBestOfAll) {
  std::array<std::size_t, 4> found{};  // by the number of cells
  for_each_vertex({0.1, 0.5, 0.97}, 11, [&](auto& labeling, auto& split, auto& best_move, auto v) {
    std::vector<CellId> expected = plain_best(labeling, split, v);
    std::vector<CellId> move = best_move.find(v);
    std::sort(expected.begin(), expected.end());
    std::sort(move.begin(), move.end());
    EXPECT_EQ(move, expected);
    ++found[std::min<std::size_t>(move.size(), 3)];
    if (!move.empty()) labeling.energy.flip(move);
  });
  for (const std::size_t count : found) EXPECT_GT(count, 0U);
}

TEST(BestMove, ThereIsNoneAtStarsThatAreTooLarge) {
  Labeling labeling(shapes::random_cube(60, 3), 11, 0.5);
  const Triangulation& t = labeling.stages.triangulation;
  LabelSplit split(t, labeling.out);
  const std::size_t most = 25;
  BestMove all(t, labeling.stars, labeling.out, labeling.energy, split, labeling.far_reach,
               t.num_cells());
  BestMove some(t, labeling.stars, labeling.out, labeling.energy, split, labeling.far_reach, most);
  std::size_t too_large = 0;
  for (const VertexId v : t.vertices()) {
    EXPECT_EQ(some.is_too_large(v), labeling.stars.star(v).size() > most);
    const std::vector<CellId> move = all.find(v);
    EXPECT_EQ(some.find(v), some.is_too_large(v) ? std::vector<CellId>() : move);
    if (some.is_too_large(v)) {
      too_large += move.empty() ? 0 : 1;
      EXPECT_TRUE(some.openings(v, to_energy(100), 10).empty());
    }
  }
  EXPECT_GT(too_large, 0U);
}

// All sets that mend v and cost little enough, by evaluating all, in canonical order.
std::vector<BestMove::Opening> plain_openings(Labeling& labeling, LabelSplit& split, VertexId v,
                                              Energy max_rise) {
  const Triangulation& t = labeling.stages.triangulation;
  std::vector<BestMove::Opening> openings;
  for (std::vector<CellId>& cells : all_moves(labeling, v)) {
    std::sort(cells.begin(), cells.end());
    const Energy change = labeling.energy.change(cells);
    if (change > max_rise || !is_attached(t, labeling.out, cells) || split.splits(cells)) continue;
    const Energy cost = labeling.energy.vertex_cost(v);
    labeling.energy.flip(cells);
    const bool mends = labeling.energy.vertex_cost(v) < cost;
    labeling.energy.flip(cells);
    if (mends) openings.push_back({change, std::move(cells)});
  }
  std::sort(openings.begin(), openings.end(), [&](const auto& a, const auto& b) {
    return a.change != b.change ? a.change < b.change : precedes(t, a.cells, b.cells);
  });
  const auto same = [](const auto& a, const auto& b) { return a.cells == b.cells; };
  openings.erase(std::unique(openings.begin(), openings.end(), same), openings.end());
  return openings;
}

TEST(BestMove, OpeningsAreAllThatMendTheVertex) {
  std::array<std::size_t, 4> found{};  // by the number of cells
  const Energy max_rise = to_energy(60);
  for_each_vertex({0.2, 0.5, 0.9}, 12, [&](auto& labeling, auto& split, auto& best_move, auto v) {
    const auto expected = plain_openings(labeling, split, v, max_rise);
    auto openings = best_move.openings(v, max_rise, 1000);
    ASSERT_EQ(openings.size(), expected.size());
    EXPECT_LE(best_move.openings(v, max_rise, 2).size(), 2U);
    for (std::size_t k = 0; k < openings.size(); ++k) {
      std::sort(openings[k].cells.begin(), openings[k].cells.end());
      EXPECT_EQ(openings[k].cells, expected[k].cells);
      EXPECT_EQ(openings[k].change, expected[k].change);
      ++found[std::min<std::size_t>(openings[k].cells.size(), 3)];
    }
    if (!openings.empty()) labeling.energy.flip(openings.front().cells);
  });
  for (std::size_t k = 1; k < found.size(); ++k) EXPECT_GT(found[k], 0U);
}

}  // namespace
}  // namespace cocoon
