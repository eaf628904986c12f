#include "geom/arrays/median.h"

#include <algorithm>
#include <cstddef>
#include <gtest/gtest.h>
#include <utility>
#include <vector>

#include "geom/random/random.h"

namespace cocoon {
namespace {

void expect_quantiles(const std::vector<double>& values) {
  std::vector<double> sorted = values;
  std::sort(sorted.begin(), sorted.end());
  for (const double fraction : {0.0, 0.01, 0.25, 0.5, 0.75, 0.999, 1.0}) {
    const std::size_t rank = std::min(
        values.size() - 1, static_cast<std::size_t>(fraction * static_cast<double>(values.size())));
    std::vector<double> copy = values;
    EXPECT_EQ(quantile_in_place(copy, fraction), sorted[rank]) << values.size() << ", " << fraction;
  }
  EXPECT_EQ(median(values), sorted[values.size() / 2]);
}

TEST(Median, IsTheElementOfItsRank) {
  EXPECT_EQ(median({}), 0);
  EXPECT_EQ(median({3}), 3);
  EXPECT_EQ(median({2, 1}), 2);
  Random random(1);
  for (const std::size_t count : {7U, 1000U, 8191U, 8192U, 30000U, 65535U, 65536U, 200003U}) {
    std::vector<double> values(count);
    for (double& value : values) value = random.uniform();
    expect_quantiles(values);
    std::sort(values.begin(), values.end());
    expect_quantiles(values);
    for (double& value : values) value = static_cast<double>(static_cast<int>(4 * value));
    expect_quantiles(values);
    expect_quantiles(std::vector<double>(count, 0.5));
  }
}

// A sample at regular distances is not always one of the whole.
TEST(Median, HoldsWhereASampleMisleads) {
  Random random(2);
  for (const auto& [count, stride] : {std::pair{1U << 18, 64U}, std::pair{1U << 14, 16U}}) {
    std::vector<double> values(count);
    for (std::size_t i = 0; i < values.size(); ++i) {
      values[i] = random.uniform() + (i % stride == 0 ? 0 : 10);
    }
    expect_quantiles(values);
  }
}

}  // namespace
}  // namespace cocoon
