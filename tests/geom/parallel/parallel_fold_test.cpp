#include "geom/parallel/parallel_fold.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <stdexcept>
#include <vector>

namespace cocoon {
namespace {

// How often each number was taken, over all parts, and how many parts there were.
struct Taken {
  std::vector<int> times;
  int parts = 1;
};

Taken take_all(int threads, std::size_t count, std::size_t grain) {
  return parallel_fold(
      {.threads = threads}, count, grain, [&] { return Taken{std::vector<int>(count)}; },
      [](Taken& part, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) ++part.times[i];
      },
      [](Taken& all, const Taken& others) {
        all.parts += others.parts;
        std::transform(all.times.begin(), all.times.end(), others.times.begin(), all.times.begin(),
                       [](int a, int b) { return a + b; });
      });
}

TEST(ParallelFold, TakesAllOnceWhateverTheThreads) {
  for (const int threads : {1, 2, 3, 40}) {
    for (const std::size_t count : {1, 7, 1000, 1003}) {
      const Taken taken = take_all(threads, count, 10);
      EXPECT_EQ(taken.times, std::vector<int>(count, 1)) << threads << " threads";
      EXPECT_LE(taken.parts, std::min(threads, static_cast<int>(most_fold_parts)));
    }
  }
}

TEST(ParallelFold, OfNothingIsAPart) {
  const Taken taken = take_all(3, 0, 10);
  EXPECT_TRUE(taken.times.empty());
  EXPECT_EQ(taken.parts, 1);
}

TEST(ParallelFold, PassesExceptionsOn) {
  const auto fail = [](int&, std::size_t, std::size_t end) {
    if (end == 100) throw std::runtime_error("at the end");
  };
  EXPECT_THROW(
      parallel_fold(
          {.threads = 3}, 100, 10, [] { return 0; }, fail, [](int& all, int part) { all += part; }),
      std::runtime_error);
}

}  // namespace
}  // namespace cocoon
