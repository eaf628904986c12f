#include "geom/angles.h"

#include <gtest/gtest.h>
#include <numbers>

#include "tests/geom/near_degenerate.h"

namespace cocoon {
namespace {

using std::numbers::pi;
using test::Family;
using test::NearDegenerate;

// The edge along x; apexes turned about it by hand.
Point turned(double angle, double along) { return {along, std::cos(angle), std::sin(angle)}; }
constexpr Point kFrom = {0, 0, 0};
constexpr Point kTo = {2, 0, 0};

TEST(WedgeAngle, OfApexesTurnedAboutTheEdge) {
  for (const double angle : {0.0, 1e-9, 0.1, 1.0, pi / 2, 3.0, pi - 1e-9, pi})
    for (const double along : {-1.0, 0.5, 7.0})
      EXPECT_NEAR(wedge_angle(kFrom, kTo, turned(0.3, 1), turned(0.3 + angle, along)), angle,
                  2e-15);
  // Smooth continuation and fold.
  EXPECT_EQ(wedge_angle(kFrom, kTo, {1, 1, 0}, {1, -1, 0}), pi);
  EXPECT_EQ(wedge_angle(kFrom, kTo, {1, 1, 0}, {5, 2, 0}), 0);
  EXPECT_TRUE(std::isnan(wedge_angle(kFrom, kTo, {1, 1, 0}, {5, 0, 0})));
  EXPECT_TRUE(std::isnan(wedge_angle(kFrom, kFrom, {1, 1, 0}, {5, 1, 0})));
}

TEST(WedgeAngle, IsPiMinusTheLiteralEquations) {
  NearDegenerate random(2);
  for (int i = 0; i < 2000; ++i) {
    const auto [p0, p1, p2, p3, unused] = random.points(Family::random);
    ASSERT_NEAR(wedge_angle(p0, p1, p2, p3), pi - literal_dihedral(p0, p1, p2, p3), 1e-7);
  }
  EXPECT_NEAR(literal_dihedral(kFrom, kTo, {1, 1, 0}, {1, -1, 0}), 0, 1e-15);
  EXPECT_NEAR(literal_dihedral(kFrom, kTo, {1, 1, 0}, {5, 2, 0}), pi, 1e-15);
}

TEST(WedgeAngle, SymmetryAndScale) {
  NearDegenerate random(3);
  for (int i = 0; i < 2000; ++i) {
    const auto [p0, p1, p2, p3, unused] = random.points(Family::random);
    const double angle = wedge_angle(p0, p1, p2, p3);
    ASSERT_EQ(wedge_angle(p0, p1, p3, p2), angle);
    ASSERT_NEAR(wedge_angle(p1, p0, p2, p3), angle, 1e-10);
    for (const double s : {0x1p-500, 0x1p500})
      ASSERT_EQ(wedge_angle(s * p0, s * p1, s * p2, s * p3), angle);
  }
}

// The power of two that brings these to 1 is larger than any number.
TEST(WedgeAngle, OfTheSmallestNumbers) {
  constexpr double s = 0x1p-1070;
  const double angle = wedge_angle(kFrom, kTo, {1, 1, 0}, {3, 2, 5});
  EXPECT_EQ(wedge_angle(kFrom, s * kTo, {s, s, 0}, {3 * s, 2 * s, 5 * s}), angle);
}

}  // namespace
}  // namespace cocoon
