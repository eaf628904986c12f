#include "geom/scaled_to_one.h"

#include <gtest/gtest.h>
#include <limits>

#include "tests/geom/near_degenerate.h"

namespace cocoon {
namespace {

TEST(ScaledToOne, LargestCoordinateIsFromOneToTwo) {
  for (int f = 0; f < static_cast<int>(test::Family::last); ++f) {
    test::NearDegenerate random(static_cast<unsigned>(f));
    for (int i = 0; i < 200; ++i) {
      for (const Vec3& v : random.points(static_cast<test::Family>(f))) {
        if (v == Vec3{}) continue;
        const double reach = max_norm(scaled_to_one(v));
        EXPECT_TRUE(reach >= 1 && reach < 2) << v;
      }
    }
  }
}

TEST(ScaledToOne, DirectionStays) {
  const Vec3 v = {3, -4, 0.5};
  for (const int exponent : {-1073, -1022, -500, 0, 500, 1021}) {
    const Vec3 scaled = {std::ldexp(v.x, exponent), std::ldexp(v.y, exponent), 0};
    EXPECT_EQ(scaled_to_one(scaled), (Vec3{0.75, -1, 0})) << exponent;
  }
  EXPECT_EQ(scaled_to_one(v), 0.25 * v);
}

TEST(ScaledToOne, WhatHasNoSizeStays) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(scaled_to_one({0, 0, 0}), Vec3{});
  EXPECT_EQ(scaled_to_one({infinity, 1, 2}), (Vec3{infinity, 1, 2}));
}

}  // namespace
}  // namespace cocoon
