#include "geom/thin_points.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <vector>

#include "geom/random.h"

namespace cocoon {
namespace {

TEST(ThinPoints, AreNoCloserThanAskedAndLeaveNoHoles) {
  Random random(7);
  std::vector<Point> points;
  points.reserve(2000);
  for (int i = 0; i < 2000; ++i)
    points.push_back({random.uniform(0, 10), random.uniform(0, 10), 0});
  const std::vector<PointId> kept = thin_points(points, [](PointId) { return 0.25; });
  EXPECT_TRUE(std::is_sorted(kept.begin(), kept.end()));
  for (const Point& p : points) {
    const auto near = std::count_if(kept.begin(), kept.end(), [&](PointId k) {
      return squared_distance(points[k.index()], p) < 0.25;
    });
    const bool is_kept =
        std::any_of(kept.begin(), kept.end(), [&](PointId k) { return points[k.index()] == p; });
    EXPECT_GE(near, 1);
    EXPECT_TRUE(!is_kept || near == 1);
  }
}

// Closer together where the points say so; of equal ones the first stays.
TEST(ThinPoints, EachByItsOwnDistance) {
  const std::vector<Point> points = {{3, 0, 0}, {0, 0, 0}, {1, 0, 0}, {0, 0, 0}, {3.5, 0, 0}};
  const auto distance_at = [&](PointId p) { return points[p.index()].x < 2 ? 4.0 : 0.01; };
  EXPECT_EQ(thin_points(points, distance_at), (std::vector{PointId(0), PointId(1), PointId(4)}));
  EXPECT_TRUE(thin_points({}, distance_at).empty());
}

}  // namespace
}  // namespace cocoon
