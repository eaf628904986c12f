#include "geom/point.h"

#include <gtest/gtest.h>
#include <limits>
#include <vector>

namespace cocoon {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(Point, LexicographicOrder) {
  const std::vector<Point> increasing = {{-1, 9, 9}, {0, 0, 5}, {0, 1, -5}, {0, 1, 0}, {2, 0, 0}};
  for (std::size_t i = 0; i < increasing.size(); ++i) {
    for (std::size_t j = 0; j < increasing.size(); ++j) {
      EXPECT_EQ(increasing[i] < increasing[j], i < j);
      EXPECT_EQ(increasing[i] == increasing[j], i == j);
    }
  }
  EXPECT_EQ((Point{0.0, 0.0, 0.0}), (Point{-0.0, 0.0, -0.0}));
}

TEST(Point, Operations) {
  const Vec3 a = {1, 2, 3};
  const Vec3 b = {4, -5, 6};
  EXPECT_EQ(a + b, (Vec3{5, -3, 9}));
  EXPECT_EQ(a - b, (Vec3{-3, 7, -3}));
  EXPECT_EQ(-a, (Vec3{-1, -2, -3}));
  EXPECT_EQ(2 * a, (Vec3{2, 4, 6}));
  EXPECT_EQ(a * 2, 2 * a);
  EXPECT_EQ(b / 2, (Vec3{2, -2.5, 3}));
  EXPECT_EQ(dot(a, b), 12);
  EXPECT_EQ(cross(a, b), (Vec3{27, 6, -13}));
  EXPECT_EQ(squared_norm(a), 14);
  EXPECT_EQ(norm({3, 0, -4}), 5);
  EXPECT_EQ(distance({1, 1, 1}, {1, 4, 5}), 5);
  EXPECT_EQ(squared_distance({1, 1, 1}, {1, 4, 5}), 25);
  EXPECT_EQ(max_norm(b), 6);
  EXPECT_EQ(a[0] + 10 * a[1] + 100 * a[2], 321);
}

TEST(Point, UnitVectors) {
  EXPECT_EQ(unit({0, 3, -4}), (Vec3{0, 0.6, -0.8}));
  EXPECT_EQ(unit({0x1p-500, 0, 0}), (Vec3{1, 0, 0}));
  EXPECT_EQ(unit({0, 0x1p500, 0}), (Vec3{0, 1, 0}));
  EXPECT_EQ(unit({0, 0, 0}), Vec3{});
  EXPECT_EQ(unit({1, infinity, 0}), Vec3{});
  EXPECT_EQ(unit({1, nan, 0}), Vec3{});
}

TEST(Point, FiniteInAllCoordinates) {
  EXPECT_TRUE(is_finite({1, -1e308, 0}));
  for (const double bad : {infinity, -infinity, nan}) {
    EXPECT_FALSE(is_finite({bad, 0, 0}));
    EXPECT_FALSE(is_finite({0, bad, 0}));
    EXPECT_FALSE(is_finite({0, 0, bad}));
  }
}

}  // namespace
}  // namespace cocoon
