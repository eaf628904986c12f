#include "geom/search/facet_bound.h"

#include <cmath>
#include <gtest/gtest.h>

#include "geom/random/random.h"
#include "geom/triangle_projection.h"
#include "tests/random_point.h"

namespace cocoon {
namespace {

double bound_of(const TrianglePoints& triangle, const Point& p) {
  return FacetBound(triangle).squared_distance(p, max_norm(p));
}

TEST(FacetBound, IsTheDistanceFromInsidesAndEdges) {
  const TrianglePoints triangle = {Point{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  EXPECT_NEAR(bound_of(triangle, {1, 1, 3}), 9, 1e-9);
  EXPECT_NEAR(bound_of(triangle, {1, 1, -3}), 9, 1e-9);
  EXPECT_NEAR(bound_of(triangle, {1, -2, 0}), 4, 1e-9);
  EXPECT_NEAR(bound_of(triangle, {3, 3, 1}), 3, 1e-9);
  EXPECT_NEAR(bound_of(triangle, {-3, -4, 0}), 16, 1e-9);  // beside a vertex less
  EXPECT_EQ(bound_of(triangle, {1, 1, 0}), 0);
  EXPECT_EQ(bound_of(triangle, {0, 0, 0}), 0);
}

// Triangles of all shapes down to needles and almost straight ones, near the origin and far off,
// and points on all sides, some of them on the triangle.
TEST(FacetBound, IsNeverMoreThanTheDistanceThatIsComputed) {
  Random random(7);
  std::size_t positive = 0;
  for (int round = 0; round < 20000; ++round) {
    const double narrowness = std::exp2(-random.uniform(0, 45));
    const Vec3 shift = (round % 3 == 0 ? 1e6 : 0.0) * random_point(random, -1, 1);
    const Point a = random_point(random, -1, 1);
    const Point b = random_point(random, -1, 1);
    const double along = random.uniform(-0.5, 1.5);
    const Point c = a + along * (b - a) + narrowness * random_point(random, -1, 1);
    const TrianglePoints triangle = {a + shift, b + shift, c + shift};
    const FacetBound bound(triangle);
    for (int k = 0; k < 20; ++k) {
      const double u = random.uniform(-0.5, 1);
      const double v = random.uniform(-0.5, 1);
      const double off = k < 5 ? 0 : std::exp2(-random.uniform(0, 40));
      const Point p = a + u * (b - a) + v * (c - a) + off * random_point(random, -1, 1) + shift;
      const double computed = closest_point_on_triangle(p, triangle).squared_distance;
      const double bounded = bound.squared_distance(p, max_norm(p));
      ASSERT_LE(bounded, computed) << narrowness << " " << off;
      positive += bounded > 0 ? 1U : 0U;
    }
  }
  EXPECT_GT(positive, 100000U);
}

TEST(FacetBound, OfWhatHasNoAreaIsZero) {
  EXPECT_EQ(FacetBound().squared_distance({5, 5, 5}, 5), 0);
  EXPECT_EQ(bound_of({Point{0, 0, 0}, {1, 0, 0}, {3, 0, 0}}, {5, 5, 5}), 0);
  EXPECT_EQ(bound_of({Point{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}, {5, 5, 5}), 0);
}

}  // namespace
}  // namespace cocoon
