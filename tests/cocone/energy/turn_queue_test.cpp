#include "cocone/energy/turn_queue.h"

#include <algorithm>
#include <cstdint>
#include <gtest/gtest.h>
#include <vector>

#include "geom/random/random.h"

namespace cocoon {
namespace {

TEST(TurnQueue, TurnsAreOrderedByClarityThenRank) {
  const std::vector<float> falling = {1, 0.75F, 0x1p-40F, 0, -0x1p-40F, -0.5F, -1};
  for (std::size_t k = 1; k < falling.size(); ++k) {
    EXPECT_GT(make_turn(falling[k - 1], 7), make_turn(falling[k], 3));
  }
  EXPECT_GT(make_turn(0.5F, 3), make_turn(0.5F, 4));
  EXPECT_EQ(rank_of(make_turn(-0.25F, 12345)), 12345U);
}

// Turns that come while others are taken, clearer ones, too, against a sorted list.
TEST(TurnQueue, TheFirstOfAllThatWaitIsNext) {
  Random random(5);
  TurnQueue queue;
  std::vector<Turn> waiting;
  std::uint32_t rank = 0;
  const auto push = [&](float clarity) {
    queue.push(clarity, rank);
    waiting.push_back(make_turn(clarity, rank));
    ++rank;
  };
  for (int k = 0; k < 3000; ++k) push(k % 3 == 0 ? 1 : static_cast<float>(random.uniform(-1, 1)));
  Turn turn = 0;
  for (std::size_t taken = 0; queue.pop(turn); ++taken) {
    const auto first = std::max_element(waiting.begin(), waiting.end());
    ASSERT_EQ(turn, *first);
    waiting.erase(first);
    if (taken > 5000) continue;
    if (taken % 4 == 0) push(static_cast<float>(random.uniform(-1, 1)));
    if (taken % 7 == 0) push(taken % 2 == 0 ? 1.0F : -1.0F);
  }
  EXPECT_TRUE(waiting.empty());
  EXPECT_FALSE(queue.pop(turn));
}

TEST(TurnQueue, KnowsWhoComesSoon) {
  TurnQueue queue;
  for (std::uint32_t rank = 0; rank < 20; ++rank) queue.push(0.5F, rank);
  Turn turn = 0;
  for (std::uint32_t rank = 0; queue.pop(turn); ++rank) {
    EXPECT_EQ(rank_of(turn), rank);
    if (rank >= 16) continue;
    EXPECT_EQ(queue.rank_ahead(3), rank + 3);
  }
}

}  // namespace
}  // namespace cocoon
