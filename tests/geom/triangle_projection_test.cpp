#include "geom/triangle_projection.h"

#include <gtest/gtest.h>
#include <numbers>

#include "tests/geom/near_degenerate.h"

namespace cocoon {
namespace {

using test::Family;
using test::NearDegenerate;

constexpr TrianglePoints kCorner = {{{0, 0, 1}, {4, 0, 1}, {0, 4, 1}}};

TEST(ProjectToTrianglePlane, HandMade) {
  const PlaneProjection above = project_to_triangle_plane({1, 2, 4}, kCorner);
  EXPECT_EQ(above.signed_distance, 3);
  EXPECT_EQ(above.projected, (Point{1, 2, 1}));
  EXPECT_EQ(above.normal, (Vec3{0, 0, 1}));
  EXPECT_EQ(above.barycentric, (std::array<double, 3>{0.25, 0.25, 0.5}));
  EXPECT_TRUE(above.is_inside());

  const PlaneProjection below = project_to_triangle_plane({-1, 0, -1}, kCorner);
  EXPECT_EQ(below.signed_distance, -2);
  EXPECT_EQ(below.barycentric, (std::array<double, 3>{1.25, -0.25, 0}));
  EXPECT_FALSE(below.is_inside());

  EXPECT_TRUE(project_to_triangle_plane({2, 2, 9}, kCorner).is_inside());  // closed: on an edge
  const PlaneProjection line =
      project_to_triangle_plane({1, 1, 1}, {{{0, 0, 0}, {1, 0, 0}, {3, 0, 0}}});
  EXPECT_TRUE(line.degenerate);
  EXPECT_FALSE(line.is_inside());
}

// The angles that the edges subtend at p_proj (the paper's test) sum to 2 pi exactly inside.
TEST(ProjectToTrianglePlane, InsideIsThePapersSumOfAngles) {
  NearDegenerate random(1);
  int inside = 0;
  for (int i = 0; i < 5000; ++i) {
    const auto [v0, v1, v2, p, unused] = random.points(Family::random);
    const PlaneProjection plane = project_to_triangle_plane(p, {v0, v1, v2});
    const auto angle = [&](const Point& from, const Point& to) {
      const Vec3 u = unit(from - plane.projected);
      const Vec3 v = unit(to - plane.projected);
      return std::acos(std::clamp(dot(u, v), -1.0, 1.0));
    };
    const double sum = angle(v0, v1) + angle(v1, v2) + angle(v2, v0);
    if (std::fabs(*std::min_element(plane.barycentric.begin(), plane.barycentric.end())) < 1e-9)
      continue;
    ASSERT_EQ(plane.is_inside(), std::fabs(sum - 2 * std::numbers::pi) < 1e-6)
        << v0 << v1 << v2 << p;
    inside += plane.is_inside() ? 1 : 0;
    const auto& [l0, l1, l2] = plane.barycentric;
    ASSERT_NEAR(distance(l0 * v0 + l1 * v1 + l2 * v2, plane.projected), 0,
                1e-10 * (1 + std::fabs(l0) + std::fabs(l1) + std::fabs(l2)));
  }
  EXPECT_GT(inside, 200);
}

TEST(ClosestPointOnTriangle, EveryFeature) {
  struct Case {
    Point p;
    Point closest;
    TriangleFeature feature;
  };
  using enum TriangleFeature;
  const Case cases[] = {
      {{1, 1, 5}, {1, 1, 1}, interior}, {{-1, -1, 1}, {0, 0, 1}, vertex0},
      {{6, 1, 0}, {4, 0, 1}, vertex1},  {{1, 6, 0}, {0, 4, 1}, vertex2},
      {{2, -3, 1}, {2, 0, 1}, edge01},  {{3, 3, 2}, {2, 2, 1}, edge12},
      {{-2, 1, 1}, {0, 1, 1}, edge20},  {{0, 0, 1}, {0, 0, 1}, vertex0},
  };
  for (const Case& c : cases) {
    const ClosestPoint closest = closest_point_on_triangle(c.p, kCorner);
    EXPECT_EQ(closest.point, c.closest) << c.p;
    EXPECT_EQ(closest.feature, c.feature) << c.p;
    EXPECT_EQ(closest.squared_distance, squared_distance(c.p, c.closest));
  }
}

TEST(ClosestPointOnTriangle, DegenerateTriangles) {
  const Point p = {1, 2, 0};
  EXPECT_EQ(closest_point_on_triangle(p, {{{0, 0, 0}, {4, 0, 0}, {2, 0, 0}}}).point,
            (Point{1, 0, 0}));
  EXPECT_EQ(closest_point_on_triangle(p, {{{3, 3, 3}, {3, 3, 3}, {3, 3, 3}}}).point,
            (Point{3, 3, 3}));
}

// No point of a dense sampling of the triangle is closer, and one is nearly as close.
TEST(ClosestPointOnTriangle, AgreesWithDenseSampling) {
  NearDegenerate random(2);
  constexpr int steps = 40;
  for (int i = 0; i < 300; ++i) {
    const auto [v0, v1, v2, p, unused] = random.points(Family::random);
    const ClosestPoint closest = closest_point_on_triangle(p, {v0, v1, v2});
    double sampled = 1e300;
    for (int j = 0; j <= steps; ++j)
      for (int k = 0; j + k <= steps; ++k) {
        const Point q = v0 + (1.0 * j / steps) * (v1 - v0) + (1.0 * k / steps) * (v2 - v0);
        sampled = std::min(sampled, distance(p, q));
      }
    const double found = std::sqrt(closest.squared_distance);
    ASSERT_LE(found, sampled + 1e-12);
    ASSERT_GE(found, sampled - 3.5 / steps);
  }
}

}  // namespace
}  // namespace cocoon
