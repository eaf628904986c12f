#include "update/model/reached_cells.h"

#include <gtest/gtest.h>
#include <limits>
#include <vector>

#include "geom/random/random.h"

namespace cocoon {
namespace {

std::vector<Point> random_points(std::size_t count, Random& random) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < count; ++i) {
    points.push_back({random.uniform(), random.uniform(), random.uniform()});
  }
  return points;
}

// Against the distances to all centers: none is missed, and none of them is far away.
TEST(PointsNear, AreThoseWithinReachAndFewOthers) {
  Random random(5);
  const std::vector<Point> points = random_points(3000, random);
  const std::vector<Point> centers = random_points(10, random);
  const double reach = 0.05;
  const std::vector<Point> near = points_near(points, centers, reach);
  std::size_t listed = 0;
  for (const Point& p : points) {
    double nearest = 10;
    for (const Point& c : centers) nearest = std::min(nearest, distance(p, c));
    const bool is_listed = listed < near.size() && near[listed] == p;
    listed += is_listed ? 1 : 0;
    if (nearest <= reach) {
      EXPECT_TRUE(is_listed);
    }
    // Within a cell, which is less than twice as wide, of one that a center reaches.
    if (is_listed) {
      EXPECT_LT(nearest, 6 * reach);
    }
  }
  EXPECT_EQ(listed, near.size());  // in their order
  EXPECT_GT(listed, 0U);
}

TEST(PointsNear, AtTheReachItselfAndAtNone) {
  const std::vector<Point> points = {{0, 0, 0}, {1, 0, 0}, {9, 0, 0}};
  const std::vector<Point> center = {{0, 0, 0}};
  EXPECT_EQ(points_near(points, center, 1), (std::vector<Point>{{0, 0, 0}, {1, 0, 0}}));
  EXPECT_EQ(points_near(points, center, 0), (std::vector<Point>{{0, 0, 0}}));
  EXPECT_TRUE(points_near(points, {}, 1).empty());
  EXPECT_TRUE(points_near({}, center, 1).empty());
}

// A number of cells over such a width is no double.
TEST(PointsNear, CentersMayBeAsCloseAsNumbersCan) {
  constexpr double least = std::numeric_limits<double>::denorm_min();
  const std::vector<Point> centers = {{0, 0, 0}, {0, 0, least}};
  EXPECT_EQ(points_near(centers, centers, 0), centers);
  EXPECT_TRUE(points_near(std::vector<Point>{{0, 0, 1}}, centers, 0).empty());
}

TEST(PointsNear, AnInfiniteReachIsThatOfAll) {
  const std::vector<Point> points = {{0, 0, 0}, {1e300, 0, 0}, {0, -5, 1}};
  constexpr double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(points_near(points, std::vector<Point>{{1, 2, 3}}, infinity), points);
  EXPECT_EQ(points_near(points, std::vector<Point>{{1, 2, 3}}, 1e308), points);
}

}  // namespace
}  // namespace cocoon
