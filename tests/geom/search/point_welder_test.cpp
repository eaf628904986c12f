#include "geom/search/point_welder.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <map>
#include <random>
#include <vector>

namespace cocoon {
namespace {

TEST(PointWelder, FindsEqualPointsAndKeepsTheFirst) {
  std::vector<Point> points;
  PointWelder welder(points);
  EXPECT_EQ(welder.add({0.0, 1, 2}), 0U);
  EXPECT_EQ(welder.add({-0.0, 1, 2}), 0U);
  EXPECT_EQ(welder.add({5e-324, 1, 2}), 1U);
  EXPECT_FALSE(std::signbit(points[0].x));
  std::mt19937 random(3);
  std::map<Point, std::size_t> known = {{points[0], 0}, {points[1], 1}};
  for (int i = 0; i < 20000; ++i) {
    const Point p = {static_cast<double>(random() % 20), static_cast<double>(random() % 20),
                     static_cast<double>(random() % 20)};
    const std::size_t expected = known.emplace(p, known.size()).first->second;
    ASSERT_EQ(welder.add(p), expected);
  }
  EXPECT_EQ(points.size(), known.size());
  for (const auto& [p, position] : known) EXPECT_EQ(welder.find(p), position);
  EXPECT_EQ(welder.find({-1, 0, 0}), PointWelder::none);
}

// A table in which all of these meet at one place takes minutes.
TEST(PointWelder, PointsThatAreNotFiniteEqualNone) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  std::vector<Point> points;
  PointWelder welder(points);
  const std::size_t count = 300'000;
  for (std::size_t i = 0; i < count; i += 3) {
    ASSERT_EQ(welder.add({nan, nan, nan}), i);
    ASSERT_EQ(welder.add({infinity, 0, 0}), i + 1);
    ASSERT_EQ(welder.add({static_cast<double>(i), 0, 0}), i + 2);
  }
  EXPECT_EQ(welder.add({3, 0, 0}), 5U);
  EXPECT_EQ(welder.find({infinity, 0, 0}), PointWelder::none);
  EXPECT_EQ(points.size(), count);
}

}  // namespace
}  // namespace cocoon
