#include "cocone/energy/max_flow.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <numeric>
#include <random>

namespace cocoon {
namespace {

struct Problem {
  struct Edge {
    std::uint32_t a, b;
    std::int64_t cost;
  };
  std::size_t nodes = 0;
  std::vector<std::int64_t> pull;  // > 0: to the source
  std::vector<Edge> edges;

  std::int64_t cost(unsigned source_set) const {
    std::int64_t total = 0;
    for (std::size_t v = 0; v < nodes; ++v) {
      const bool source = ((source_set >> v) & 1U) != 0;
      if (source != (pull[v] > 0)) total += std::abs(pull[v]);
    }
    for (const Edge& e : edges) {
      if (((source_set >> e.a) & 1U) != ((source_set >> e.b) & 1U)) total += e.cost;
    }
    return total;
  }

  // Intersections of minimum cuts are minimum cuts: the smallest one is within all others.
  unsigned smallest_of_cheapest() const {
    unsigned best = 0;
    for (unsigned set = 1; set < (1U << nodes); ++set) {
      if (cost(set) < cost(best)) best = set;
    }
    for (unsigned set = 0; set < (1U << nodes); ++set) {
      if (cost(set) == cost(best)) best &= set;
    }
    return best;
  }

  unsigned solve() const {
    MaxFlow flow(nodes);
    for (std::uint32_t v = 0; v < nodes; ++v) {
      if (pull[v] > 0) flow.pull_to_source(v, pull[v]);
      if (pull[v] < 0) flow.pull_to_sink(v, -pull[v]);
    }
    for (const Edge& e : edges) flow.add_edge(e.a, e.b, e.cost);
    const std::vector<std::uint8_t> side = flow.source_side();
    unsigned set = 0;
    for (std::size_t v = 0; v < nodes; ++v) set |= static_cast<unsigned>(side[v]) << v;
    return set;
  }
};

TEST(MaxFlow, ChainIsCutAtItsCheapestEdge) {
  const Problem chain{4, {10, 0, 0, -10}, {{0, 1, 5}, {1, 2, 2}, {2, 3, 4}}};
  EXPECT_EQ(chain.solve(), 0b0011U);
}

TEST(MaxFlow, NothingPulledIsOnTheSinkSide) {
  const Problem idle{3, {0, 0, 0}, {{0, 1, 1}, {1, 2, 1}}};
  EXPECT_EQ(idle.solve(), 0U);
  const Problem tie{2, {3, -3}, {{0, 1, 3}}};  // all three cuts cost 3
  EXPECT_EQ(tie.solve(), 0U);
}

TEST(MaxFlow, FindsTheSmallestOfAllMinimumCutsInAnyOrder) {
  std::mt19937 random(1);
  const auto below = [&](unsigned n) { return static_cast<std::uint32_t>(random() % n); };
  for (int round = 0; round < 300; ++round) {
    Problem p;
    p.nodes = 2 + below(8);
    for (std::size_t v = 0; v < p.nodes; ++v) p.pull.push_back(std::int64_t{below(9)} - 4);
    for (std::uint32_t k = 0; k < 2 * p.nodes; ++k) {
      const auto n = static_cast<unsigned>(p.nodes);
      p.edges.push_back({below(n), below(n), below(4)});
    }
    const unsigned expected = p.smallest_of_cheapest();
    EXPECT_EQ(p.solve(), expected) << "round " << round;
    std::shuffle(p.edges.begin(), p.edges.end(), random);
    EXPECT_EQ(p.solve(), expected) << "round " << round << ", shuffled";
  }
}

// Graphs like those of cells, against the smallest source side that plain augmenting paths leave.
TEST(MaxFlow, AgreesWithAugmentingPathsOnLattices) {
  std::mt19937 random(2);
  const auto below = [&](unsigned n) { return static_cast<std::int64_t>(random() % n); };
  for (int round = 0; round < 10; ++round) {
    constexpr std::uint32_t side = 6;
    constexpr std::uint32_t count = side * side * side;
    const unsigned pulled = round % 2 == 0 ? 1 : 20;  // one of so many
    MaxFlow flow(count);
    std::vector<std::vector<std::int64_t>> room(count + 2, std::vector<std::int64_t>(count + 2));
    const auto add = [&](std::uint32_t a, std::uint32_t b) {
      const std::int64_t cost = below(10);
      flow.add_edge(a, b, cost);
      room[a][b] = room[b][a] = cost;
    };
    for (std::uint32_t v = 0; v < count; ++v) {
      if (v % side + 1 < side) add(v, v + 1);
      if (v / side % side + 1 < side) add(v, v + side);
      if (v / side / side + 1 < side) add(v, v + side * side);
      if (below(pulled) != 0) continue;
      const std::int64_t pull = below(60) - 30;
      if (pull > 0) flow.pull_to_source(v, room[count][v] = pull);
      if (pull < 0) flow.pull_to_sink(v, room[v][count + 1] = -pull);
    }
    std::vector<std::uint32_t> from;
    const auto search = [&] {
      from.assign(count + 2, count + 2);
      std::vector<std::uint32_t> queue{count};
      from[count] = count;
      for (std::size_t k = 0; k < queue.size(); ++k) {
        for (std::uint32_t v = 0; v < count + 2; ++v) {
          if (from[v] != count + 2 || room[queue[k]][v] == 0) continue;
          from[v] = queue[k];
          queue.push_back(v);
        }
      }
      return from[count + 1] != count + 2;
    };
    while (search()) {
      std::int64_t amount = 1000;
      for (std::uint32_t v = count + 1; v != count; v = from[v]) {
        amount = std::min(amount, room[from[v]][v]);
      }
      for (std::uint32_t v = count + 1; v != count; v = from[v]) {
        room[from[v]][v] -= amount;
        room[v][from[v]] += amount;
      }
    }
    const std::vector<std::uint8_t> sides = flow.source_side();
    for (std::uint32_t v = 0; v < count; ++v) {
      EXPECT_EQ(sides[v] != 0, from[v] != count + 2) << "round " << round << ", node " << v;
    }
  }
}

}  // namespace
}  // namespace cocoon
