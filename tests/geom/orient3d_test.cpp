#include "geom/orient3d.h"

#include <gtest/gtest.h>
#include <map>
#include <sstream>
#include <vector>

#include "geom/exact/predicate_levels.h"
#include "ref/rational_predicates.h"
#include "tests/geom/near_degenerate.h"

namespace cocoon {
namespace {

using test::Family;
using test::NearDegenerate;
using enum PredicateLevel;

struct Case {
  const char* name;
  std::array<Point, 4> p;
  Sign sign;
  PredicateLevel level;
};

void expect_decision(const Case& c) {
  const PredicateDecision decision = decide_orient3d(c.p[0], c.p[1], c.p[2], c.p[3]);
  EXPECT_EQ(decision.sign, c.sign) << c.name;
  EXPECT_EQ(decision.level, c.level) << c.name;
  EXPECT_EQ(orient3d(c.p[0], c.p[1], c.p[2], c.p[3]), c.sign) << c.name;
  EXPECT_EQ(ref::orient3d(c.p[0], c.p[1], c.p[2], c.p[3]), c.sign) << c.name;
}

TEST(Orient3d, LevelThatDecidesHandMadeInputs) {
  const double ulp = 0x1p-52;
  const std::vector<Case> cases = {
      {"unit corner", {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, Sign::positive, filter},
      {"below the plane", {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, -1}}}, Sign::negative, filter},
      {"plane of a grid", {{{0, 0, 3}, {1, 0, 3}, {0, 1, 3}, {7, 7, 3}}}, Sign::zero, permanent},
      // The extents multiply to 1, the only product is 4 ulp: below 49 u, above 9 u of itself.
      {"one small product",
       {{{0, 0, 0}, {1, 0, 0}, {1, 4 * ulp, 0}, {1, 1, 1}}},
       Sign::positive,
       permanent},
      {"diagonal plane", {{{0, 0, 0}, {1, 0, 1}, {0, 1, 1}, {1, 1, 2}}}, Sign::zero, grid_64},
      {"an ulp above it",
       {{{0, 0, 0}, {1, 0, 1}, {0, 1, 1}, {1, 1, 2 + 2 * ulp}}},
       Sign::positive,
       grid_64},
      {"an ulp below it",
       {{{0, 0, 0}, {1, 0, 1}, {0, 1, 1}, {1, 1, 2 - ulp}}},
       Sign::negative,
       grid_64},
      {"2^-80 above it",
       {{{0, 0, 0}, {1, 0, 1}, {0, 1, 1 - 0x1p-53}, {1, 0x1p-80, 1}}},
       Sign::negative,
       grid_128},
      {"2^-200 above it",
       {{{0, 0, 0x1p-200}, {1, 0, 1}, {0, 1, 1}, {1, 1, 2}}},
       Sign::positive,
       grid_256},
      {"2^-400 above it",
       {{{0, 0, 0x1p-400}, {1, 0, 1}, {0, 1, 1}, {1, 1, 2}}},
       Sign::positive,
       grid_512},
      {"2^-1074 above it",
       {{{0, 0, 0x1p-1074}, {1, 0, 1}, {0, 1, 1}, {1, 1, 2}}},
       Sign::positive,
       wide},
      {"overflowing differences",
       {{{-0x1.8p1023, 0, 0}, {0x1.8p1023, 0, 0}, {0, 0x1.8p1023, 0}, {0, 0, 0x1.8p1023}}},
       Sign::positive,
       grid_64},
      {"subnormal corner",
       {{{0, 0, 0}, {0x1p-1074, 0, 0}, {0, 0x1p-1074, 0}, {0, 0, 0x1p-1074}}},
       Sign::positive,
       grid_64},
  };
  for (const Case& c : cases) expect_decision(c);
}

TEST(Orient3d, EveryLevelAgreesWithRationalNumbers) {
  std::map<PredicateLevel, int> decided;
  NearDegenerate random(1);
  for (int f = 0; f < static_cast<int>(Family::last); ++f) {
    for (int i = 0; i < 700; ++i) {
      const auto [a, b, c, d, e] = random.points(static_cast<Family>(f));
      const Sign expected = ref::orient3d(a, b, c, d);
      const auto input = [&] {
        std::ostringstream out;
        out << "family " << f << ": " << a << b << c << d;
        return out.str();
      };
      const PredicateDecision decision = decide_orient3d(a, b, c, d);
      ++decided[decision.level];
      ASSERT_EQ(decision.sign, expected) << input();
      ASSERT_EQ(orient3d(a, b, c, d), expected) << input();
      for (const FilteredDeterminant& level :
           {orient3d_filter(a, b, c, d), orient3d_permanent(a, b, c, d)})
        if (level.is_certain()) {
          ASSERT_EQ(sign_of(level.value), expected) << input();
        }
      for (const PredicateLevel narrowest : {grid_64, grid_128, grid_256, grid_512, wide})
        ASSERT_EQ(orient3d_on_grid(a, b, c, d, narrowest).sign, expected) << input();
    }
  }
  for (const PredicateLevel level : {filter, permanent, grid_64, grid_128, wide})
    EXPECT_GT(decided[level], 0) << "no input reached level " << static_cast<int>(level);
}

TEST(Orient3d, ChangesSignWithEveryExchangeOfTwoPoints) {
  NearDegenerate random(2);
  for (int f = 0; f < static_cast<int>(Family::last); ++f) {
    for (int i = 0; i < 200; ++i) {
      const auto [a, b, c, d, e] = random.points(static_cast<Family>(f));
      const Sign sign = orient3d(a, b, c, d);
      ASSERT_EQ(orient3d(b, a, c, d), -sign);
      ASSERT_EQ(orient3d(a, c, b, d), -sign);
      ASSERT_EQ(orient3d(a, b, d, c), -sign);
      ASSERT_EQ(orient3d(b, c, d, a), -sign);
    }
  }
}

// Scaling by powers of two and mirror images change the sign as they should.
TEST(Orient3d, ScalesExactly) {
  NearDegenerate random(3);
  for (int i = 0; i < 1000; ++i) {
    const auto [a, b, c, d, e] = random.points(Family::coplanar);
    const Sign sign = orient3d(a, b, c, d);
    for (const double s : {0x1p-900, 0x1p-300, 0x1p300, 0x1p1000})
      ASSERT_EQ(orient3d(s * a, s * b, s * c, s * d), sign);
    ASSERT_EQ(orient3d(-a, -b, -c, -d), -sign);
  }
}

// Near-coplanar grids of one ulp: where the double determinant is noise, the filter must say so.
TEST(Orient3d, FilterStaysWithinItsBound) {
  int wrong_in_doubles = 0;
  for (int i = 0; i < 64; ++i) {
    for (int j = 0; j < 64; ++j) {
      const Point a = {0.5 + i * 0x1p-53, 0.5 + j * 0x1p-53, 0.5};
      const Point b = {12, 12, 12};
      const Point c = {24, 24, 24 + 0x1p-48};
      const Point d = {0.1, 0.7, 18};
      const Sign expected = ref::orient3d(a, b, c, d);
      const FilteredDeterminant level = orient3d_filter(a, b, c, d);
      if (sign_of(level.value) != expected) ++wrong_in_doubles;
      if (level.is_certain()) {
        ASSERT_EQ(sign_of(level.value), expected);
      }
      ASSERT_EQ(orient3d(a, b, c, d), expected);
    }
  }
  EXPECT_GT(wrong_in_doubles, 100);
}

// Sums of products just above the largest double: an infinite partial sum has no sign to trust.
TEST(Orient3d, FilterRefusesOverflow) {
  const double s = 0x1p341;
  const Point a = {0, 0, 0};
  const Point b = {1.5 * s, 1.5 * s, 1.5 * s};
  const Point c = {-1.5 * s, 1.5 * s, 1.25 * s};
  const Point d = {1.5 * s, -1.5 * s, 1.75 * s};
  EXPECT_FALSE(orient3d_filter(1e3 * a, 1e3 * b, 1e3 * c, 1e3 * d).is_certain());
  EXPECT_EQ(orient3d(a, b, c, d), ref::orient3d(a, b, c, d));
  EXPECT_EQ(orient3d(a, 1e3 * b, 1e3 * c, 1e3 * d), ref::orient3d(a, b, c, d));
}

TEST(Orient2d, AgreesWithRationalNumbers) {
  NearDegenerate random(4);
  std::map<Sign, int> seen;
  for (int f = 0; f < static_cast<int>(Family::last); ++f) {
    for (int i = 0; i < 1000; ++i) {
      const auto [a, b, c, d, e] = random.points(static_cast<Family>(f));
      const Sign sign = orient2d(a.x, a.y, b.x, b.y, c.x, c.y);
      ++seen[sign];
      ASSERT_EQ(sign, ref::orient2d(a.x, a.y, b.x, b.y, c.x, c.y)) << f << a << b << c;
      ASSERT_EQ(orient2d(b.x, b.y, a.x, a.y, c.x, c.y), -sign);
      // A third point within an ulp of the line ab.
      const Point near = {0.5 * a.x + 0.5 * b.x, std::nextafter(0.5 * a.y + 0.5 * b.y, b.y), 0};
      ASSERT_EQ(orient2d(a.x, a.y, b.x, b.y, near.x, near.y),
                ref::orient2d(a.x, a.y, b.x, b.y, near.x, near.y));
    }
  }
  EXPECT_EQ(seen.size(), 3U);
  EXPECT_EQ(orient2d(0, 0, 1, 0, 0, 1), Sign::positive);
  EXPECT_EQ(orient2d(0, 0, 1, 1, 1e300, 1e300), Sign::zero);
  EXPECT_EQ(orient2d(0, 0, 1, 1, 1e300, std::nextafter(1e300, 0)), Sign::negative);
}

TEST(AreCollinear, OnlyExactly) {
  EXPECT_TRUE(are_collinear({0, 0, 0}, {1, 2, 3}, {-2, -4, -6}));
  EXPECT_TRUE(are_collinear({1, 1, 1}, {1, 1, 1}, {5, 6, 7}));
  EXPECT_TRUE(are_collinear({0, 0, 0}, {0, 0, 1e-300}, {0, 0, 1e300}));
  EXPECT_FALSE(are_collinear({0, 0, 0}, {1, 2, 3}, {-2, -4, std::nextafter(-6, 0)}));
  EXPECT_FALSE(are_collinear({0, 0, 0}, {1, 0, 0}, {2, 0, 0x1p-1074}));
  EXPECT_FALSE(are_collinear({0, 0, 0}, {0, 1, 0}, {0, 2, 0x1p-1074}));
}

}  // namespace
}  // namespace cocoon
