#include "geom/insphere.h"

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
  std::array<Point, 5> p;
  Sign sign;
  PredicateLevel level;
};

void expect_decision(const Case& c) {
  const auto& [p0, p1, p2, p3, p4] = c.p;
  const PredicateDecision decision = decide_insphere(p0, p1, p2, p3, p4);
  EXPECT_EQ(decision.sign, c.sign) << c.name;
  EXPECT_EQ(decision.level, c.level) << c.name;
  EXPECT_EQ(insphere(p0, p1, p2, p3, p4), c.sign) << c.name;
  EXPECT_EQ(ref::insphere(p0, p1, p2, p3, p4), c.sign) << c.name;
}

// The corner tetrahedron of the unit cube: orient3d > 0, and all 8 corners on its sphere.
constexpr Point kO = {0, 0, 0};
constexpr Point kX = {1, 0, 0};
constexpr Point kY = {0, 1, 0};
constexpr Point kZ = {0, 0, 1};

TEST(Insphere, LevelThatDecidesHandMadeInputs) {
  const double ulp = 0x1p-52;
  const std::vector<Case> cases = {
      {"center", {{kO, kX, kY, kZ, {0.5, 0.5, 0.5}}}, Sign::positive, filter},
      {"outside", {{kO, kX, kY, kZ, {2, 2, 2}}}, Sign::negative, filter},
      {"center, cell turned over", {{kO, kY, kX, kZ, {0.5, 0.5, 0.5}}}, Sign::negative, filter},
      {"opposite corner", {{kO, kX, kY, kZ, {1, 1, 1}}}, Sign::zero, grid_64},
      {"an ulp outside", {{kO, kX, kY, kZ, {1, 1, 1 + ulp}}}, Sign::negative, grid_64},
      {"an ulp inside", {{kO, kX, kY, kZ, {1, 1, 1 - ulp}}}, Sign::positive, grid_64},
      {"2^-43 outside", {{kO, kX, kY, kZ, {1, 1, 1 + 0x1p-43}}}, Sign::negative, permanent},
      {"2^-100 outside", {{kO, kX, kY, kZ, {1, 1, -0x1p-100}}}, Sign::negative, grid_128},
      {"2^-200 inside", {{kO, kX, kY, kZ, {1, 1, 0x1p-200}}}, Sign::positive, grid_256},
      {"2^-400 inside", {{kO, kX, kY, kZ, {1, 1, 0x1p-400}}}, Sign::positive, grid_512},
      {"2^-1074 inside", {{kO, kX, kY, kZ, {1, 1, 0x1p-1074}}}, Sign::positive, wide},
      {"all in one plane x", {{kO, kY, kZ, {0, 1, 1}, {0, 5, 7}}}, Sign::zero, permanent},
  };
  for (const Case& c : cases) expect_decision(c);
}

TEST(Insphere, EveryLevelAgreesWithRationalNumbers) {
  std::map<PredicateLevel, int> decided;
  NearDegenerate random(1);
  for (int f = 0; f < static_cast<int>(Family::last); ++f) {
    for (int i = 0; i < 600; ++i) {
      const auto [a, b, c, d, e] = random.points(static_cast<Family>(f));
      const Sign expected = ref::insphere(a, b, c, d, e);
      const auto input = [&] {
        std::ostringstream out;
        out << "family " << f << ": " << a << b << c << d << e;
        return out.str();
      };
      const PredicateDecision decision = decide_insphere(a, b, c, d, e);
      ++decided[decision.level];
      ASSERT_EQ(decision.sign, expected) << input();
      ASSERT_EQ(insphere(a, b, c, d, e), expected) << input();
      for (const FilteredDeterminant& level :
           {insphere_filter(a, b, c, d, e), insphere_permanent(a, b, c, d, e)})
        if (level.is_certain()) {
          ASSERT_EQ(sign_of(level.value), expected) << input();
        }
      for (const PredicateLevel narrowest : {grid_64, grid_128, grid_256, grid_512, wide})
        ASSERT_EQ(insphere_on_grid(a, b, c, d, e, narrowest).sign, expected) << input();
    }
  }
  for (const PredicateLevel level : {filter, permanent, grid_64, grid_128, wide})
    EXPECT_GT(decided[level], 0) << "no input reached level " << static_cast<int>(level);
}

TEST(Insphere, ChangesSignWithEveryExchangeOfTwoPoints) {
  NearDegenerate random(2);
  for (int f = 0; f < static_cast<int>(Family::last); ++f) {
    for (int i = 0; i < 100; ++i) {
      const auto [a, b, c, d, e] = random.points(static_cast<Family>(f));
      const Sign sign = insphere(a, b, c, d, e);
      ASSERT_EQ(insphere(b, a, c, d, e), -sign);
      ASSERT_EQ(insphere(a, c, b, d, e), -sign);
      ASSERT_EQ(insphere(a, b, d, c, e), -sign);
      ASSERT_EQ(insphere(a, b, c, e, d), -sign);
      ASSERT_EQ(insphere(e, b, c, d, a), -sign);
    }
  }
}

TEST(Insphere, ScalesExactly) {
  NearDegenerate random(3);
  for (int i = 0; i < 300; ++i) {
    const auto [a, b, c, d, e] = random.points(Family::cospherical);
    const Sign sign = insphere(a, b, c, d, e);
    for (const double s : {0x1p-900, 0x1p-498, 0x1p498, 0x1p1000})
      ASSERT_EQ(insphere(s * a, s * b, s * c, s * d, s * e), sign);
    ASSERT_EQ(insphere(-a, -b, -c, -d, -e), -sign);
  }
}

// The bound of the first filter is not only safe: on points in general position it decides.
TEST(Insphere, FilterDecidesNearlyAllRandomInputs) {
  NearDegenerate random(5);
  int certain = 0;
  for (int i = 0; i < 10000; ++i) {
    const auto [a, b, c, d, e] = random.points(Family::random);
    certain += insphere_filter(a, b, c, d, e).is_certain() ? 1 : 0;
  }
  EXPECT_GE(certain, 9995);  // measured: 10000
}

// Just inside and just outside the range that the filter accepts, determinants that cancel: its
// value may be noise, but then it must not be certain.
TEST(Insphere, FilterSurvivesTheEdgesOfItsRange) {
  NearDegenerate random(6);
  int certain = 0;
  for (const int exponent :
       {-215, -200, -192, -190, -188, -150, 150, 200, 203, 204, 205, 210, 340}) {
    const double s = std::ldexp(1.0, exponent);
    for (int i = 0; i < 200; ++i) {
      const auto [a, b, c, d, e] = random.points(i % 2 == 0 ? Family::cospherical : Family::random);
      const FilteredDeterminant level = insphere_filter(s * a, s * b, s * c, s * d, s * e);
      if (!level.is_certain()) continue;
      ++certain;
      ASSERT_EQ(sign_of(level.value), ref::insphere(a, b, c, d, e)) << a << b << c << d << e;
    }
  }
  EXPECT_GT(certain, 500);
}

}  // namespace
}  // namespace cocoon
