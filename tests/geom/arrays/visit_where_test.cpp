#include "geom/arrays/visit_where.h"

#include <cstdint>
#include <gtest/gtest.h>
#include <vector>

#include "geom/random/random.h"

namespace cocoon {
namespace {

TEST(VisitWhere, AllInOrder) {
  Random random(1);
  for (const std::size_t count : {0U, 1U, 127U, 128U, 129U, 1000U}) {
    for (const std::size_t one_in : {1U, 3U, 200U, 100000U}) {
      std::vector<std::uint8_t> flags(count);
      std::vector<std::size_t> expected;
      for (std::size_t i = 0; i < count; ++i) {
        if (random.below(one_in) != 0) continue;
        flags[i] = 1;
        expected.push_back(i);
      }
      std::vector<std::size_t> found;
      visit_where(
          count, [&](std::size_t i) { return flags[i] != 0; },
          [&](std::size_t i) { found.push_back(i); });
      EXPECT_EQ(found, expected) << count << ", one in " << one_in;
    }
  }
}

}  // namespace
}  // namespace cocoon
