#include "geom/circumsphere.h"

#include <algorithm>
#include <array>
#include <gtest/gtest.h>
#include <map>

#include "geom/orient3d.h"
#include "ref/rational_predicates.h"
#include "tests/geom/near_degenerate.h"

namespace cocoon {
namespace {

using test::Family;
using test::NearDegenerate;

double largest(const Vec3& v) { return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)}); }

void expect_level(const Circumcenter& result, const Point& center, CenterLevel level) {
  EXPECT_EQ(result.center, center) << result.center;
  EXPECT_EQ(result.level, level) << static_cast<int>(result.level);
}

TEST(Circumcenter, LevelOfHandMadeTetrahedra) {
  using enum CenterLevel;
  const Point o = {0, 0, 0};
  const Point x = {1, 0, 0};
  const Point y = {0, 1, 0};
  const Point z = {0, 0, 1};
  expect_level(circumcenter(o, x, y, z), {0.5, 0.5, 0.5}, doubles);
  // A sliver 2^-40 high: rounding |d|^2 = 2 + 2^-80 moves the center far along z.
  expect_level(circumcenter(o, x, y, {1, 1, 0x1p-40}), {0.5, 0.5, 0x1p-41}, exact);
  // A square cannot be told from a flat tetrahedron by less.
  expect_level(circumcenter(o, x, y, {1, 1, 0}), {0.5, 0.5, 0}, facet);
  // On a line: no facet either.
  expect_level(circumcenter(o, x, {2, 0, 0}, {5, 0, 0}), {2, 0, 0}, centroid);
  // Center beyond the largest double: the circumcenter of the facet (o, y, x).
  expect_level(circumcenter(o, x, y, {2, 3, 0x1p-1074}), {0.5, 0.5, 0}, facet);
}

TEST(Circumcenter, LevelOfHandMadeTriangles) {
  using enum CenterLevel;
  expect_level(circumcenter({0, 0, 0}, {2, 0, 0}, {0, 2, 0}), {1, 1, 0}, doubles);
  // Thin along an axis costs nothing: no product cancels another.
  expect_level(circumcenter({0, 0, 5}, {1, 0x1p-40, 5}, {2, 0, 5}), {1, 0x1p-41 - 0x1p39, 5},
               doubles);
  // Thin along a diagonal does. The bisector of the first two points is x + y = 1.
  const Point third = {2, 2 + 0x1p-38, 0};
  const Circumcenter thin = circumcenter({0, 0, 0}, {1, 1, 0}, third);
  EXPECT_EQ(thin.level, exact);
  EXPECT_EQ(thin.center.x + thin.center.y, 1);
  EXPECT_NEAR(distance(thin.center, third) / norm(thin.center), 1, 1e-15);
  expect_level(circumcenter({0, 0, 0}, {1, 1, 1}, {5, 5, 5}), {2, 2, 2}, centroid);
}

// Level exact is right to a few roundings, level doubles to 2^-23 of the radius even for slivers.
TEST(Circumcenter, AgreesWithRationalNumbers) {
  std::map<CenterLevel, int> seen;
  NearDegenerate random(1);
  for (const Family family : {Family::random, Family::coplanar, Family::cospherical, Family::flat,
                              Family::far_sphere, Family::grid}) {
    for (int i = 0; i < 300; ++i) {
      const auto [a, b, c, d, e] = random.points(family);
      if (orient3d(a, b, c, d) == Sign::zero) continue;
      const Circumcenter result = circumcenter(a, b, c, d);
      const Point expected = ref::circumcenter(a, b, c, d);
      ++seen[result.level];
      const double error = largest(result.center - expected);
      const double rounding = 0x1p-52 * largest(expected);
      if (result.level == CenterLevel::doubles) {
        ASSERT_LE(error, rounding + 0x1p-22 * distance(expected, a)) << a << b << c << d;
      } else {
        ASSERT_EQ(result.level, CenterLevel::exact);
        ASSERT_LE(error, rounding + 0x1p-50 * largest(expected - a)) << a << b << c << d;
      }
    }
  }
  EXPECT_GT(seen[CenterLevel::doubles], 500);
  EXPECT_GT(seen[CenterLevel::exact], 100);
}

TEST(Circumcenter, SameBitsForEveryOrderOfTheVertices) {
  NearDegenerate random(2);
  for (int f = 0; f < static_cast<int>(Family::last); ++f) {
    for (int i = 0; i < 20; ++i) {
      const auto [a, b, c, d, e] = random.points(static_cast<Family>(f));
      const Circumcenter expected = circumcenter(a, b, c, d);
      ASSERT_TRUE(is_finite(expected.center)) << f << a << b << c << d;
      std::array<int, 4> order = {0, 1, 2, 3};
      const std::array<Point, 4> p = {a, b, c, d};
      do {
        const auto at = [&](std::size_t k) { return p[static_cast<std::size_t>(order[k])]; };
        const Circumcenter result = circumcenter(at(0), at(1), at(2), at(3));
        ASSERT_EQ(result.center, expected.center);
        ASSERT_EQ(result.level, expected.level);
      } while (std::next_permutation(order.begin(), order.end()));
      ASSERT_EQ(circumcenter(a, b, c).center, circumcenter(c, a, b).center);
    }
  }
}

TEST(Circumcenter, ScalesByPowersOfTwo) {
  NearDegenerate random(3);
  for (int i = 0; i < 200; ++i) {
    const auto [a, b, c, d, e] = random.points(i % 2 == 0 ? Family::cospherical : Family::random);
    const Circumcenter expected = circumcenter(a, b, c, d);
    for (const double s : {0x1p-500, 0x1p-100, 0x1p500, 0x1p900}) {
      const Circumcenter result = circumcenter(s * a, s * b, s * c, s * d);
      ASSERT_EQ(result.center, s * expected.center);
      ASSERT_EQ(result.level, expected.level);
      ASSERT_EQ(circumcenter(s * a, s * b, s * c).center, s * circumcenter(a, b, c).center);
    }
  }
}

// The triangle's center lies in its plane and is as far from all three.
TEST(Circumcenter, OfATriangleIsEquidistantAndInItsPlane) {
  NearDegenerate random(4);
  for (int i = 0; i < 1000; ++i) {
    const auto [a, b, c, d, e] = random.points(Family::random);
    const Point center = circumcenter(a, b, c).center;
    const double radius = distance(center, a);
    ASSERT_NEAR(distance(center, b), radius, 2e-6 * radius);
    ASSERT_NEAR(distance(center, c), radius, 2e-6 * radius);
    ASSERT_NEAR(dot(center - a, unit(cross(b - a, c - a))), 0, 1e-6 * radius);
  }
}

}  // namespace
}  // namespace cocoon
