#include "geom/arrays/disjoint_sets.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <vector>

#include "geom/random/random.h"

namespace cocoon {
namespace {

TEST(DisjointSets, RootsAreTheSmallestMembers) {
  DisjointSets sets(6);
  for (std::uint32_t k = 0; k < 6; ++k) EXPECT_EQ(sets.root(k), k);
  EXPECT_TRUE(sets.join(5, 4));
  EXPECT_TRUE(sets.join(4, 2));
  EXPECT_FALSE(sets.join(2, 5));
  EXPECT_FALSE(sets.join(3, 3));
  EXPECT_EQ(sets.root(5), 2U);
  EXPECT_EQ(sets.root(3), 3U);
}

TEST(DisjointSets, AgreeWithLabels) {
  constexpr std::uint32_t count = 200;
  Random random(6);
  DisjointSets sets(count);
  std::vector<std::uint32_t> label(count);
  for (std::uint32_t k = 0; k < count; ++k) label[k] = k;
  for (int step = 0; step < 300; ++step) {
    const auto a = static_cast<std::uint32_t>(random.below(count));
    const auto b = static_cast<std::uint32_t>(random.below(count));
    EXPECT_EQ(sets.join(a, b), label[a] != label[b]);
    const auto [low, high] = std::minmax({label[a], label[b]});
    std::replace(label.begin(), label.end(), high, low);
    for (std::uint32_t k = 0; k < count; ++k) ASSERT_EQ(sets.root(k), label[k]);
  }
}

}  // namespace
}  // namespace cocoon
