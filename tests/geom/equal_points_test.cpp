#include "geom/equal_points.h"

#include <gtest/gtest.h>
#include <map>

#include "geom/random.h"

namespace cocoon {
namespace {

TEST(EqualPoints, ByHand) {
  const std::vector<Point> points{{1, 2, 3}, {0, 0, 0}, {1, 2, 3}, {-0.0, 0, -0.0}, {3, 2, 1}};
  EXPECT_EQ(first_of_equal(points), (std::vector<std::uint32_t>{0, 1, 0, 1, 4}));
  EXPECT_TRUE(first_of_equal({}).empty());
}

TEST(EqualPoints, AsAMapTellsIt) {
  Random random(1);
  for (const std::size_t n : {1U, 50U, 3000U, 40000U}) {
    std::vector<Point> points;
    std::map<std::array<double, 3>, std::uint32_t> firsts;
    std::vector<std::uint32_t> expected;
    for (std::uint32_t i = 0; i < n; ++i) {
      // One coordinate of few values, and in part copies of points before.
      Point p{random.uniform(), static_cast<double>(random.below(3)), 1e-300 * random.uniform()};
      if (i > 0 && random.below(5) == 0) p = points[random.below(i)];
      points.push_back(p);
      expected.push_back(firsts.emplace(std::array{p.x, p.y, p.z}, i).first->second);
    }
    EXPECT_EQ(first_of_equal(points), expected);
    // Those that are first of their kind, then all: the first ones differ.
    std::vector<Point> twice;
    for (std::uint32_t i = 0; i < n; ++i) {
      if (expected[i] == i) twice.push_back(points[i]);
    }
    const std::size_t distinct = twice.size();
    twice.insert(twice.end(), points.begin(), points.end());
    EXPECT_EQ(first_of_equal(twice, distinct), first_of_equal(twice));
  }
}

}  // namespace
}  // namespace cocoon
