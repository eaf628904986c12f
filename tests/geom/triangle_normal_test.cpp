#include "geom/triangle_normal.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "geom/random/random.h"

namespace cocoon {
namespace {

TEST(TriangleNormal, PointsToTheCounterclockwiseSide) {
  const TriangleNormal normal = triangle_normal({0, 0, 0}, {2, 0, 0}, {0, 3, 0});
  EXPECT_EQ(normal.direction, (Vec3{0, 0, 1}));
  EXPECT_FALSE(normal.exact);
  EXPECT_EQ(triangle_normal({0, 0, 0}, {0, 3, 0}, {2, 0, 0}).direction, (Vec3{0, 0, -1}));
}

TEST(TriangleNormal, SameBitsForEveryOrderOfTheVertices) {
  Random random(1);
  for (int i = 0; i < 1000; ++i) {
    std::array<Point, 3> p{random.in_unit_cube(), random.in_unit_cube(), random.in_unit_cube()};
    // Some of them nearly on a line, so that integers decide.
    if (i % 2 == 0) p[2] = p[0] + 0.25 * (p[1] - p[0]);
    const Vec3 direction = triangle_normal(p[0], p[1], p[2]).direction;
    EXPECT_EQ(triangle_normal(p[1], p[2], p[0]).direction, direction);
    EXPECT_EQ(triangle_normal(p[2], p[0], p[1]).direction, direction);
    EXPECT_EQ(triangle_normal(p[1], p[0], p[2]).direction, -direction);
  }
}

// (1e16, 1, 0) x (1e16 + 2, 1, 0) = (0, 0, -2): lost in double products.
TEST(TriangleNormal, NearlyCollinearVertices) {
  const TriangleNormal normal = triangle_normal({0, 0, 0}, {1e16, 1, 0}, {1e16 + 2, 1, 0});
  EXPECT_TRUE(normal.exact);
  EXPECT_EQ(normal.direction, (Vec3{0, 0, -1}));
  // One ulp off the diagonal of the unit square, tilted.
  const double above = std::nextafter(0.5, 1.0);
  const Vec3 tilted = triangle_normal({0, 0, 0}, {1, 1, 1}, {0.5, above, 0.5}).direction;
  EXPECT_NEAR(tilted.x, -std::sqrt(0.5), 1e-15);
  EXPECT_EQ(tilted.y, 0);
  EXPECT_NEAR(tilted.z, std::sqrt(0.5), 1e-15);
}

TEST(TriangleNormal, ZeroExactlyForCollinearVertices) {
  EXPECT_EQ(triangle_normal({0, 0, 0}, {1, 2, 3}, {3, 6, 9}).direction, Vec3{});
  EXPECT_EQ(triangle_normal({1, 1, 1}, {1, 1, 1}, {3, 6, 9}).direction, Vec3{});
  EXPECT_EQ(triangle_normal({1, 1, 1}, {1, 1, 1}, {1, 1, 1}).direction, Vec3{});
}

TEST(TriangleNormal, AnyMagnitude) {
  const double tiny = std::numeric_limits<double>::denorm_min();
  const double huge = std::numeric_limits<double>::max();
  for (const double scale : {tiny, 1e-300, 1e-160, 1e160, 1e300, huge}) {
    EXPECT_EQ(triangle_normal({0, 0, 0}, {scale, 0, 0}, {0, 0, scale}).direction, (Vec3{0, -1, 0}));
  }
  // Differences that overflow, and edges of extremely different lengths.
  EXPECT_EQ(triangle_normal({-huge, 0, 0}, {huge, 0, 0}, {0, huge, 0}).direction, (Vec3{0, 0, 1}));
  EXPECT_EQ(triangle_normal({0, 0, 0}, {huge, 0, 0}, {0, tiny, 0}).direction, (Vec3{0, 0, 1}));
}

}  // namespace
}  // namespace cocoon
