#include "update/cloud/rim_index.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "geom/random/random.h"
#include "tests/update/hand_made_models.h"

namespace cocoon {
namespace {

// By the number of edges that a ray to the right of p crosses.
bool inside_star(const std::vector<Point>& polygon, const Point& p) {
  bool inside = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point& a = polygon[i];
    const Point& b = polygon[(i + 1) % polygon.size()];
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) {
      inside = !inside;
    }
  }
  return inside;
}

// A star with deep notches: convex and reflex corners, where the nearest thing is an end of edges.
TEST(RimIndex, SideAgreesWithRayCrossing) {
  Random random(17);
  std::vector<Point> star;
  const std::size_t n = 30;
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / n;
    const double radius = i % 2 == 0 ? 10 : 4 + random.uniform();
    star.push_back({radius * std::cos(angle), radius * std::sin(angle), 0});
  }
  RimLoop loop = testing::loop_towards(star, std::vector<Vec3>(n, Vec3{0, 0, 1}), {0, 0, 0});
  const std::vector<CloudRim> rims = {testing::rim_of({loop})};
  const RimIndex index(rims);
  std::size_t inside = 0;
  for (int round = 0; round < 4000; ++round) {
    const Point p = {random.uniform(-12, 12), random.uniform(-12, 12), 0};
    const bool expected = inside_star(star, p);
    inside += expected ? 1 : 0;
    EXPECT_EQ(index.side_of(p).on_cloud_side, expected) << p.x << " " << p.y;
  }
  EXPECT_GT(inside, 500U);
}

// The nearest edge tells whether its loop is partial; edges with cloud beyond them are not asked.
TEST(RimIndex, TellsPartialLoops) {
  CloudRim rim =
      testing::rim_of({testing::circle(12, {0, 0, 0}, 2), testing::circle(12, {10, 0, 0}, 2)});
  rim.loops[0].inner.assign(12, 0);
  rim.loops[1].inner.assign(12, 0);
  rim.loops[1].inner[3] = 1;
  const std::vector<CloudRim> rims = {rim};
  const RimIndex index(rims);
  EXPECT_FALSE(index.side_of({1, 0, 0}).at_partial_loop);
  EXPECT_TRUE(index.side_of({9, 0, 0}).at_partial_loop);
}

TEST(RimIndex, NoRim) {
  const RimIndex index({});
  EXPECT_TRUE(index.empty());
  EXPECT_FALSE(index.side_of({0, 0, 0}).on_cloud_side);
}

}  // namespace
}  // namespace cocoon
