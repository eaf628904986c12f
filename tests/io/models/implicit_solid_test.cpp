#include "io/models/implicit_solid.h"

#include <cmath>
#include <gtest/gtest.h>

#include "geom/random/random.h"

namespace cocoon {
namespace {

TEST(ImplicitSolid, CapsuleIsTheDistanceToASegment) {
  const Point a = {0, 0, 0};
  const Point b = {0, 0, 2};
  EXPECT_DOUBLE_EQ(round_cone({3, 0, 1}, a, 0.5, b, 0.5), 2.5);
  EXPECT_DOUBLE_EQ(round_cone({0, 0, 5}, a, 0.5, b, 0.5), 2.5);
  EXPECT_DOUBLE_EQ(round_cone({0, 0, 1}, a, 0.5, b, 0.5), -0.5);
}

// The hull of two balls is the union of all balls between them.
TEST(ImplicitSolid, RoundConeIsTheLeastDistanceToItsBalls) {
  const Point a = {1, -1, 0};
  const Point b = {2, 1, 3};
  const double radius_a = 1.2;
  const double radius_b = 0.4;
  Random random(5);
  for (int k = 0; k < 200; ++k) {
    const Point p = 8 * random.in_unit_cube() - Vec3{3, 4, 3};
    double least = 100;
    for (int i = 0; i <= 2000; ++i) {
      const double t = i / 2000.0;
      const double radius = (1 - t) * radius_a + t * radius_b;
      least = std::min(least, distance(p, (1 - t) * a + t * b) - radius);
    }
    EXPECT_NEAR(round_cone(p, a, radius_a, b, radius_b), least, 1e-5);
  }
}

TEST(ImplicitSolid, EllipsoidIsZeroOnItsSurfaceWithAUnitGradient) {
  const Vec3 half = {3, 2, 0.5};
  EXPECT_LT(ellipsoid({0, 0, 0}, half), 0);
  Random random(6);
  for (int k = 0; k < 100; ++k) {
    const Vec3 u = random.on_unit_sphere();
    const Point p = {half.x * u.x, half.y * u.y, half.z * u.z};
    EXPECT_NEAR(ellipsoid(p, half), 0, 1e-12);
    EXPECT_NEAR(norm(gradient([&](const Point& q) { return ellipsoid(q, half); }, p, 1e-5)), 1,
                1e-4);
  }
}

TEST(ImplicitSolid, FilletsTouchNothingOutsideTheirBand) {
  EXPECT_EQ(filleted_union(0.1, 0.4, 0.3), 0.1);
  EXPECT_LT(filleted_union(0.1, 0.39, 0.3), 0.1);
  EXPECT_EQ(filleted_intersection(0.1, 0.4, 0.3), 0.4);
  EXPECT_GT(filleted_intersection(0.11, 0.4, 0.3), 0.4);
  EXPECT_EQ(filleted_difference(0.1, 0.4, 0.3), 0.1);
  EXPECT_EQ(filleted_difference(-0.7, -0.4, 0.3), 0.4);
  EXPECT_GT(filleted_difference(0.1, 0.1, 0.3), 0.1);
}

}  // namespace
}  // namespace cocoon
