#include "geom/triangle_projection.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>

#include "geom/working_scale.h"
#include "ref/rational_distance.h"
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

// Corners on a line but for the rounding of decimal numbers: the normal would be anything.
TEST(ProjectToTrianglePlane, ALineUpToRoundingIsDegenerate) {
  const PlaneProjection line = project_to_triangle_plane(
      {0.05, 0.17, -0.06}, {{{-0.03, 0.01, 0.02}, {0.02, 0.11, -0.03}, {-0.01, 0.05, 0}}});
  EXPECT_TRUE(line.degenerate);
  EXPECT_EQ(line.normal, Vec3{});
  EXPECT_FALSE(line.is_inside());
  const PlaneProjection flat =
      project_to_triangle_plane({0, 0, 2}, {{{-1, 0, 1}, {1, 0, 1}, {0, 0x1p-24, 1}}});
  EXPECT_EQ(flat.normal, (Vec3{0, 0, 1}));
  EXPECT_EQ(flat.signed_distance, 1);
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

TEST(ClosestPointOnTriangle, FeaturesAreRenumbered) {
  const Point queries[] = {{1, 1, 5},  {-1, -1, 1}, {6, 1, 0}, {1, 6, 0},
                           {2, -3, 1}, {3, 3, 2},   {-2, 1, 1}};
  std::array<std::size_t, 3> order = {0, 1, 2};
  do {
    const TrianglePoints turned = {kCorner[order[0]], kCorner[order[1]], kCorner[order[2]]};
    for (const Point& p : queries) {
      EXPECT_EQ(renumbered(closest_point_on_triangle(p, turned).feature, order),
                closest_point_on_triangle(p, kCorner).feature)
          << p;
    }
  } while (std::next_permutation(order.begin(), order.end()));
}

TEST(ClosestPointOnTriangle, DegenerateTriangles) {
  const Point p = {1, 2, 0};
  EXPECT_EQ(closest_point_on_triangle(p, {{{0, 0, 0}, {4, 0, 0}, {2, 0, 0}}}).point,
            (Point{1, 0, 0}));
  EXPECT_EQ(closest_point_on_triangle(p, {{{3, 3, 3}, {3, 3, 3}, {3, 3, 3}}}).point,
            (Point{3, 3, 3}));
}

double rounded_distance(const Point& p, const TrianglePoints& triangle) {
  return std::sqrt(closest_point_on_triangle(p, triangle).squared_distance);
}

TEST(ClosestPointOnTriangle, CornersOnALineUpToRounding) {
  struct Case {
    Point p;
    TrianglePoints triangle;
    double distance;
  };
  const Case cases[] = {
      {{0.05, 0.17, -0.06},
       {{{-0.03, 0.01, 0.02}, {0.02, 0.11, -0.03}, {-0.01, 0.05, 0}}},
       std::sqrt(0.0054)},
      {{1.3, -0.1, -0.2}, {{{0.4, 1.5, 1.6}, {1.9, 0.5, 0.1}, {1, 1.1, 1}}}, 0.9},
  };
  for (Case c : cases) {
    std::sort(c.triangle.begin(), c.triangle.end());
    do {
      EXPECT_NEAR(rounded_distance(c.p, c.triangle), c.distance, 1e-15) << c.triangle[0];
    } while (std::next_permutation(c.triangle.begin(), c.triangle.end()));
  }
}

double longest_edge(const TrianglePoints& t) {
  return std::max({distance(t[0], t[1]), distance(t[1], t[2]), distance(t[2], t[0])});
}

// Off by no more than what the header says: by 2^-28 of the longest edge where there is no plane,
// in proportion to the others where one is short; and by rounding, of the normal and others.
void expect_distance_of_rationals(const Point& p, const TrianglePoints& t) {
  const double exact = std::sqrt(ref::squared_distance_to_triangle(p, t));
  const double found = rounded_distance(p, t);
  const double longest = longest_edge(t);
  const double share = longest > 0 ? 1 / longest : 0;
  const double others =
      share * distance(t[0], t[1]) * (share * distance(t[1], t[2])) * distance(t[2], t[0]);
  const double size = longest + max_norm(p - t[0]);
  ASSERT_NEAR(found, exact, 0x1p-23 * others + 0x1p-48 * size) << t[0] << t[1] << t[2] << p;
}

TEST(ClosestPointOnTriangle, OfEveryFamilyAtWorkingSize) {
  for (int f = 0; f < static_cast<int>(Family::last); ++f) {
    NearDegenerate random(static_cast<unsigned>(f));
    for (int i = 0; i < 300; ++i) {
      std::array<Point, 5> p = random.points(static_cast<Family>(f));
      const double scale = working_scale(p);
      for (Point& q : p) q = scale * q;
      expect_distance_of_rationals(p[3], {p[0], p[1], p[2]});
    }
  }
}

// The third corner near the segment of the other two, between them or beyond, by any power of two.
TEST(ClosestPointOnTriangle, OfNeedlesOfEveryHeight) {
  NearDegenerate random(3);
  for (int i = 0; i < 4000; ++i) {
    const std::array<Point, 5> p = random.points(Family::random);
    const double height = std::ldexp(1.0, -random.integer(10, 55));
    const Point third = p[0] + random.uniform(-0.5, 1.5) * (p[1] - p[0]) + height * p[2];
    const Point near = p[0] + random.uniform(-2, 3) * (p[1] - p[0]);
    // In the direction of what rounding makes of the normal, or anywhere.
    const Vec3 normal = unit(cross(p[1] - p[0], third - p[0]));
    const Vec3 away = random.integer(0, 1) == 0 ? p[3] : normal;
    const Point query = near + std::ldexp(1.0, -random.integer(-5, 30)) * away;
    expect_distance_of_rationals(query, {p[0], p[1], third});
  }
}

// One corner far out, whichever it is: the others tell where the plane is.
TEST(ClosestPointOnTriangle, OfOneCornerFarOut) {
  NearDegenerate random(4);
  for (int i = 0; i < 3000; ++i) {
    const std::array<Point, 5> p = random.points(Family::random);
    TrianglePoints corners = {p[0], p[1], std::ldexp(1.0, random.integer(1, 60)) * p[2]};
    std::rotate(corners.begin(), corners.begin() + random.integer(0, 2), corners.end());
    expect_distance_of_rationals(p[3], corners);
    const TrianglePoints flat = {{{0, 0, 0}, {1, 0, 0}, {0.5, 0x1p300, 0}}};
    TrianglePoints turned = flat;
    std::rotate(turned.begin(), turned.begin() + random.integer(0, 2), turned.end());
    const Point above = {0.5, random.uniform(1, 2), p[4].z};
    ASSERT_EQ(rounded_distance(above, turned), std::fabs(p[4].z)) << above;
  }
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
