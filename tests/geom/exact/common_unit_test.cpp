#include "geom/exact/common_unit.h"

#include <gtest/gtest.h>
#include <limits>
#include <vector>

namespace cocoon {
namespace {

double unit_of(std::vector<Point> points) { return common_unit(points); }

TEST(CommonUnit, IsTheLowestBitOfAnyCoordinate) {
  EXPECT_EQ(unit_of({{4, 8, -12}}), 4);
  EXPECT_EQ(unit_of({{4, 8, -12}, {0, 0, 0.375}}), 0.125);
  EXPECT_EQ(unit_of({{0x1p60, 0, 0}, {0, 1, 0}}), 1);
  EXPECT_EQ(unit_of({{0.1, 0, 0}}), 0x1p-55);  // 0.1 = odd * 2^-55
}

TEST(CommonUnit, OfNothingIsZero) {
  EXPECT_EQ(unit_of({}), 0);
  EXPECT_EQ(unit_of({{0, -0.0, 0}}), 0);
}

TEST(CommonUnit, ReachesTheEndsOfTheRange) {
  EXPECT_EQ(unit_of({{std::numeric_limits<double>::denorm_min(), 1, 0}}), 0x1p-1074);
  EXPECT_EQ(unit_of({{0x1p1023, 0, 0}}), 0x1p1023);
}

// Scaling by a power of two scales the unit.
TEST(CommonUnit, Scales) {
  const std::vector<Point> points = {{1.25, 3, -7}, {0.75, 100, 2}};
  for (const double scale : {0x1p-40, 0x1p3, 0x1p200}) {
    std::vector<Point> scaled;
    for (const Point& p : points) scaled.push_back(scale * p);
    EXPECT_EQ(common_unit(scaled), scale * 0.25);
  }
}

}  // namespace
}  // namespace cocoon
