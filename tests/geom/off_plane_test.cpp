#include "geom/off_plane.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <vector>

#include "geom/orient3d.h"
#include "geom/random/random.h"

namespace cocoon {
namespace {

// In the plane z = y / 2, on a grid of powers of two: exactly.
std::vector<Point> slanted_points() {
  Random random(5);
  std::vector<Point> points;
  for (int i = 0; i < 300; ++i) {
    const double y = static_cast<double>(random.below(1024)) / 64;
    points.push_back({static_cast<double>(random.below(1024)) / 64, y, y / 2});
  }
  points.push_back(points[7]);
  return points;
}

TEST(OffPlane, FlatPointsMoveALittleAlongTheNormal) {
  const std::vector<Point> points = slanted_points();
  const std::vector<Point> moved = moved_off_plane(points);
  ASSERT_EQ(moved.size(), points.size());
  double farthest = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec3 step = moved[i] - points[i];
    farthest = std::max(farthest, norm(step));
    EXPECT_NEAR(step.x, 0, 1e-15);
    EXPECT_NEAR(step.y, -step.z / 2, 1e-14);
  }
  EXPECT_LT(farthest, 16 * 0x1p-20);
  EXPECT_GT(farthest, 8 * 0x1p-20);
  EXPECT_EQ(moved.back(), moved[7]);  // equal points
  EXPECT_TRUE(moved_off_plane(moved).empty());
}

TEST(OffPlane, TheOrderOfPointsDoesNotMatter) {
  const std::vector<Point> points = slanted_points();
  const std::vector<Point> backward(points.rbegin(), points.rend());
  std::vector<Point> moved = moved_off_plane(backward);
  std::reverse(moved.begin(), moved.end());
  EXPECT_EQ(moved, moved_off_plane(points));
}

TEST(OffPlane, CoordinatesOfAnySize) {
  const std::vector<Point> points = slanted_points();
  for (const double factor : {0x1p-900, 0x1p-270, 0x1p300, 0x1p1000}) {
    std::vector<Point> scaled = points;
    for (Point& p : scaled) p = factor * p;
    const std::vector<Point> moved = moved_off_plane(scaled);
    ASSERT_EQ(moved.size(), points.size()) << factor;
    EXPECT_TRUE(moved_off_plane(moved).empty()) << factor;
    EXPECT_LT(norm(moved[0] / factor - points[0]), 16 * 0x1p-20) << factor;
  }
}

// Where a share of the extent would be less than the last bit of a coordinate.
TEST(OffPlane, FarFromTheOriginToo) {
  for (const double height : {1e9, 1e10, 1e12, 1e14}) {
    std::vector<Point> points = slanted_points();
    for (Point& p : points) p.z = height;
    const std::vector<Point> moved = moved_off_plane(points);
    ASSERT_EQ(moved.size(), points.size());
    EXPECT_TRUE(moved_off_plane(moved).empty()) << height;
  }
}

TEST(OffPlane, OthersAreLeft) {
  std::vector<Point> points = slanted_points();
  points.push_back({1, 1, std::nextafter(0.5, 1)});
  EXPECT_TRUE(moved_off_plane(points).empty());
  EXPECT_TRUE(moved_off_plane(std::vector<Point>{}).empty());
  EXPECT_TRUE(moved_off_plane(std::vector<Point>(9, {1, 2, 3})).empty());
  EXPECT_TRUE(moved_off_plane(std::vector<Point>{{0, 0, 0}, {1, 2, 3}, {2, 4, 6}}).empty());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(
      moved_off_plane(std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {nan, 0, 0}}).empty());
}

}  // namespace
}  // namespace cocoon
