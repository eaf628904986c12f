#include "geom/parallel/parallel_list.h"

#include <cstddef>
#include <gtest/gtest.h>
#include <vector>

#include "geom/errors.h"
#include "tests/stop_after.h"

namespace cocoon {
namespace {

TEST(ParallelList, InTheOrderOfTheChunks) {
  std::vector<std::size_t> expected;
  for (std::size_t i = 0; i < 10007; ++i) {
    if (i % 3 == 0 || i < 500) expected.push_back(i * i);
  }
  for (const int threads : {1, 4}) {
    for (const std::size_t grain : {1U, 64U, 20000U}) {
      EXPECT_EQ(parallel_list<std::size_t>(
                    Execution{.threads = threads}, 10007, grain,
                    [](std::size_t begin, std::size_t end, std::vector<std::size_t>& found) {
                      for (std::size_t i = begin; i < end; ++i) {
                        if (i % 3 == 0 || i < 500) found.push_back(i * i);
                      }
                    }),
                expected);
    }
  }
}

TEST(ParallelList, TheSameAsAPartOfAStage) {
  const auto find = [](std::size_t begin, std::size_t end, std::vector<std::size_t>& found) {
    for (std::size_t i = begin; i < end; i += 7) found.push_back(i);
  };
  test::StopAfter watcher(1000);
  const Execution execution{2, &watcher};
  const auto expected = parallel_list<std::size_t>({}, 10007, 16, find);
  EXPECT_EQ(parallel_list<std::size_t>(execution, {"listing"}, 10007, 16, find), expected);
  EXPECT_LT(watcher.left, 950);  // it was told about a hundred times
  test::StopAfter stopper(3);
  EXPECT_THROW(parallel_list<std::size_t>({2, &stopper}, {"listing"}, 10007, 16, find), Cancelled);
}

TEST(ParallelList, OfNothing) {
  EXPECT_TRUE(parallel_list<int>({}, 0, 16, [](std::size_t, std::size_t, std::vector<int>&) {
                FAIL();
              }).empty());
}

}  // namespace
}  // namespace cocoon
