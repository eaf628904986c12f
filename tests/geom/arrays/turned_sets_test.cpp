#include "geom/arrays/turned_sets.h"

#include <algorithm>
#include <cstdint>
#include <gtest/gtest.h>
#include <vector>

#include "geom/random/random.h"

namespace cocoon {
namespace {

// What is known, spelled out: joins tell how two of them are turned, at random.
TEST(TurnedSets, KnowWhatFollowsFromTheJoins) {
  constexpr std::uint32_t count = 300;
  Random random(7);
  TurnedSets sets(count);
  std::vector<std::uint32_t> set_of(count);  // by its smallest member
  std::vector<std::uint32_t> side(count);    // against that of the smallest
  for (std::uint32_t k = 0; k < count; ++k) set_of[k] = k;
  for (int step = 0; step < 600; ++step) {
    const auto a = static_cast<std::uint32_t>(random.below(count));
    const auto b = static_cast<std::uint32_t>(random.below(count));
    const auto turned = static_cast<std::uint32_t>(random.below(2));
    const bool known = set_of[a] == set_of[b];
    EXPECT_EQ(sets.join(a, b, turned), !known || (side[a] ^ side[b]) == turned);
    const std::uint32_t kept = std::min(set_of[a], set_of[b]);
    const std::uint32_t gone = std::max(set_of[a], set_of[b]);
    const std::uint32_t between = side[a] ^ side[b] ^ turned;
    for (std::uint32_t k = 0; k < count && !known; ++k) {
      if (set_of[k] != gone) continue;
      set_of[k] = kept;
      side[k] ^= between;
    }
    const auto asked = static_cast<std::uint32_t>(random.below(count));
    EXPECT_EQ(sets.place(asked).root, set_of[asked]);
    EXPECT_EQ(sets.place(asked).turned, side[asked]);
  }
}

}  // namespace
}  // namespace cocoon
