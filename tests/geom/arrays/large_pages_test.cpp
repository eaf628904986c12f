#include "geom/arrays/large_pages.h"

#include <gtest/gtest.h>
#include <numeric>
#include <vector>

namespace cocoon {
namespace {

// A wish must change nothing, whatever the size and the alignment, written to already or not.
TEST(LargePages, LeaveTheContentsAsTheyAre) {
  for (const std::size_t count : {0U, 1U, 1000U, 1U << 20, 3000001U}) {
    std::vector<std::uint32_t> numbers;
    numbers.reserve(count);
    prefer_large_pages(numbers);
    numbers.resize(count);
    std::iota(numbers.begin(), numbers.end(), 7U);
    prefer_large_pages(numbers);
    std::uint32_t expected = 7;
    for (const std::uint32_t number : numbers) ASSERT_EQ(number, expected++);
  }
}

}  // namespace
}  // namespace cocoon
