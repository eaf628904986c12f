#include "geom/search/equal_points.h"

#include <gtest/gtest.h>
#include <map>

#include "geom/random/random.h"

namespace cocoon {
namespace {

TEST(EqualPoints, ByHand) {
  const std::vector<Point> points{{1, 2, 3}, {0, 0, 0}, {1, 2, 3}, {-0.0, 0, -0.0}, {3, 2, 1}};
  EXPECT_EQ(repeated_points(points), (std::vector<RepeatedPoint>{{2, 0}, {3, 1}}));
  EXPECT_TRUE(repeated_points({}).empty());
}

TEST(EqualPoints, AsAMapTellsIt) {
  Random random(1);
  for (const std::size_t n : {1U, 50U, 3000U, 40000U}) {
    std::vector<Point> points;
    std::map<std::array<double, 3>, std::uint32_t> firsts;
    std::vector<RepeatedPoint> expected;
    std::vector<Point> twice;  // those that are first of their kind, then all
    for (std::uint32_t i = 0; i < n; ++i) {
      // One coordinate of few values, and in part copies of points before.
      Point p{random.uniform(), static_cast<double>(random.below(3)), 1e-300 * random.uniform()};
      if (i > 0 && random.below(5) == 0) p = points[random.below(i)];
      points.push_back(p);
      const auto [first, is_new] = firsts.emplace(std::array{p.x, p.y, p.z}, i);
      if (is_new) {
        twice.push_back(p);
      } else {
        expected.push_back({i, first->second});
      }
    }
    EXPECT_EQ(repeated_points(points), expected);
    const std::size_t distinct = twice.size();
    twice.insert(twice.end(), points.begin(), points.end());
    EXPECT_EQ(repeated_points(twice, distinct), repeated_points(twice));
    std::vector<std::uint32_t> all;
    for (std::uint32_t i = 0; i < distinct; ++i) all.push_back(i);
    EXPECT_EQ(repeated_points(twice, distinct, all), repeated_points(twice));
  }
}

TEST(EqualPoints, DistinctOnesInOrder) {
  const std::vector<Point> points{{1, 2, 0}, {1, 0, 3}, {1, 2, 0}, {0, 9, 9}, {1, 2, -0.0}};
  EXPECT_EQ(distinct_points(points), (std::vector<Point>{{0, 9, 9}, {1, 0, 3}, {1, 2, 0}}));
  EXPECT_TRUE(distinct_points({}).empty());
}

// Of the points that are known to differ only those near the others are looked at.
TEST(EqualPoints, AmongThoseNear) {
  const std::vector<Point> points{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  EXPECT_EQ(repeated_points(points, 3, std::vector<std::uint32_t>{1, 2}),
            (std::vector<RepeatedPoint>{{3, 1}, {4, 2}}));
  EXPECT_EQ(repeated_points(points, 3, std::vector<std::uint32_t>{2}),
            (std::vector<RepeatedPoint>{{4, 2}}));
}

}  // namespace
}  // namespace cocoon
