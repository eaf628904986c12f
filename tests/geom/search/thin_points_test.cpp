#include "geom/search/thin_points.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <vector>

#include "geom/random/random.h"
#include "geom/working_scale.h"

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

TEST(ThinPoints, JustAsFarAsAskedStay) {
  const std::vector<Point> points = {{0, 0, 0}, {2, 0, 0}, {3.5, 0, 0}};
  EXPECT_EQ(thin_points(points, 2), (std::vector{PointId(0), PointId(1)}));
}

// Sizes whose squares are no doubles: the same points stay at all of them.
TEST(ThinPoints, OfOneDistanceAtAnySize) {
  Random random(3);
  std::vector<Point> points = {{0, 0, 0}, {0, 0, 0}};
  for (int i = 0; i < 300; ++i) {
    points.push_back({random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1)});
  }
  const std::vector<PointId> kept = thin_points(points, 0.125);
  EXPECT_EQ(kept, thin_points(points, [](PointId) { return 1.0 / 64; }));
  EXPECT_LT(kept.size(), 250U);
  for (const double scale : {0x1p-900, 0x1p-300, 0x1p300, 0x1p900}) {
    EXPECT_EQ(thin_points(scaled(points, scale), 0.125 * scale), kept) << scale;
  }
  EXPECT_EQ(thin_points(points, 1e-300).size(), points.size() - 1) << "equal points are one";
  EXPECT_EQ(thin_points(points, 1e300), std::vector{PointId(0)});
}

// Their squared distance is 0, but they are not equal.
TEST(ThinPoints, DifferentOnesStayHoweverNear) {
  const std::vector<Point> points = {{1e-170, 0, 0}, {0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {-0.0, 0, 0}};
  const std::vector different = {PointId(0), PointId(1), PointId(2)};
  EXPECT_EQ(thin_points(points, 0), different);
  EXPECT_EQ(thin_points(points, 1e-180), different);
  EXPECT_EQ(thin_points(points, 1e-140), (std::vector{PointId(1), PointId(2)}));
}

}  // namespace
}  // namespace cocoon
