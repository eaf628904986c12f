#include "geom/arrays/points_of.h"

#include <gtest/gtest.h>

namespace cocoon {
namespace {

TEST(PointsOf, AreInTheOrderOfTheIds) {
  const std::vector<Point> points = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  const std::vector<PointId> ids = {PointId(2U), PointId(0U), PointId(2U)};
  EXPECT_EQ(points_of(points, ids), (std::vector<Point>{{2, 0, 0}, {0, 0, 0}, {2, 0, 0}}));
  EXPECT_TRUE(points_of(points, {}).empty());
}

}  // namespace
}  // namespace cocoon
