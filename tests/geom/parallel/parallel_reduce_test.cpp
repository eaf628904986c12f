#include "geom/parallel/parallel_reduce.h"

#include <atomic>
#include <cstdint>
#include <gtest/gtest.h>
#include <string>

namespace cocoon {
namespace {

constexpr std::size_t many = std::size_t{1} << 20;

TEST(ParallelReduce, CombinesInTheOrderOfTheChunks) {
  const auto name = [](std::size_t begin, std::size_t end) {
    return std::to_string(begin) + "-" + std::to_string(end) + " ";
  };
  const auto join = [](const std::string& a, const std::string& b) { return a + b; };
  const std::string expected = parallel_reduce({1}, many, std::string(), name, join);
  EXPECT_EQ(expected.substr(0, 8), "0-32768 ");
  EXPECT_EQ(parallel_reduce({3}, many, std::string(), name, join), expected);
  EXPECT_EQ(parallel_reduce({3}, 0, std::string("none"), name, join), "none");
}

TEST(FirstFailing, IsTheSmallestOnAnyNumberOfThreads) {
  for (const int threads : {1, 4}) {
    for (const std::size_t first : {std::size_t{0}, std::size_t{40000}, many - 1}) {
      const auto holds = [&](std::size_t i) { return i < first || (i % 3 == 0 && i != first); };
      EXPECT_EQ(first_failing({threads}, many, holds), first) << threads;
    }
    EXPECT_EQ(first_failing({threads}, many, [](std::size_t) { return true; }), many);
    EXPECT_EQ(first_failing({threads}, 0, [](std::size_t) { return false; }), 0U);
  }
}

TEST(FirstFailing, ChunksBehindItAreNotLookedAt) {
  std::size_t calls = 0;
  const auto holds = [&](std::size_t i) { return ++calls > 0 && i != 10; };
  EXPECT_EQ(first_failing({1}, many, holds), 10U);
  EXPECT_EQ(calls, 11U);
  std::atomic<std::size_t> all_calls{0};
  const auto counted = [&](std::size_t i) { return ++all_calls > 0 && i != 10; };
  EXPECT_EQ(first_failing({4}, many, counted), 10U);
  EXPECT_LT(all_calls, many);
}

}  // namespace
}  // namespace cocoon
