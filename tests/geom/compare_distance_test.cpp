// Which of two points is nearer, by hand and against integers that are wide enough.
#include "geom/compare_distance.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <gtest/gtest.h>
#include <limits>

#include "geom/exact/exact_integer.h"
#include "geom/random/random.h"

namespace cocoon {
namespace {

TEST(CompareDistance, DecidesPlainCases) {
  EXPECT_EQ(compare_distance({0, 0, 0}, {1, 0, 0}, {0, 2, 0}), Sign::negative);
  EXPECT_EQ(compare_distance({0, 0, 0}, {3, 0, 0}, {0, 2, 0}), Sign::positive);
  EXPECT_EQ(compare_distance({1, 1, 1}, {2, 3, 3}, {-1, 2, 3}), Sign::zero);
  EXPECT_EQ(compare_distance({1, 2, 3}, {1, 2, 3}, {1, 2, 3}), Sign::zero);
}

// Off the plane between a and b by one ulp, where floating point sees a tie.
TEST(CompareDistance, DecidesBelowRounding) {
  const Point a{1, 0.25, 3};
  const Point b{-1, 0.25, 3};
  for (const double x : {0.0, 0x1p-60, -0x1p-60, 0x1p-1000, -0x1p-1000}) {
    const Sign expected = x == 0 ? Sign::zero : x > 0 ? Sign::negative : Sign::positive;
    EXPECT_EQ(compare_distance({x, 0, 0}, a, b), expected) << x;
  }
}

TEST(CompareDistance, HoldsOverTheWholeRange) {
  const double huge = std::numeric_limits<double>::max();
  const double tiny = std::numeric_limits<double>::denorm_min();
  EXPECT_EQ(compare_distance({0, 0, 0}, {huge, 0, 0}, {0, -huge, 0}), Sign::zero);
  EXPECT_EQ(compare_distance({tiny, 0, 0}, {huge, 0, 0}, {0, -huge, 0}), Sign::negative);
  EXPECT_EQ(compare_distance({-huge, 0, 0}, {huge, 0, 0}, {0, huge, 0}), Sign::positive);
  EXPECT_EQ(compare_distance({0, 0, 0}, {tiny, 0, 0}, {0, 2 * tiny, 0}), Sign::negative);
  EXPECT_EQ(compare_distance({0, 0, 0}, {tiny, tiny, 0}, {0, tiny, -tiny}), Sign::zero);
}

// On integers up to 2^20 the squares are exact in 64-bit integers.
TEST(CompareDistance, AgreesWithIntegers) {
  Random random(3);
  const auto coordinate = [&](std::size_t range) { return static_cast<long>(random.below(range)); };
  int ties = 0;
  for (int k = 0; k < 20000; ++k) {
    const std::size_t range = k % 2 == 0 ? 8 : std::size_t{1} << 20;
    long v[9];
    for (long& c : v) c = coordinate(range);
    const auto squared = [&](int i) {
      const long x = v[i] - v[0];
      const long y = v[i + 1] - v[1];
      const long z = v[i + 2] - v[2];
      return x * x + y * y + z * z;
    };
    const auto point = [&](int i) {
      return Point{static_cast<double>(v[i]), static_cast<double>(v[i + 1]),
                   static_cast<double>(v[i + 2])};
    };
    const long difference = squared(3) - squared(6);
    const Sign expected = difference == 0  ? Sign::zero
                          : difference > 0 ? Sign::positive
                                           : Sign::negative;
    ties += difference == 0 ? 1 : 0;
    ASSERT_EQ(compare_distance(point(0), point(3), point(6)), expected);
  }
  EXPECT_GT(ties, 100);
}

// Differences of 56 bits, which doubles round, and distances that are the same to about a rounding.
TEST(CompareDistance, AgreesWithIntegersAroundTheBoundOfItsFilter) {
  Random random(4);
  using Integers = std::array<std::int64_t, 3>;
  const auto squared = [](const Integers& p, const Integers& q) {
    Uint128 sum = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto difference = static_cast<Uint128>(std::abs(p[k] - q[k]));
      sum += difference * difference;
    }
    return sum;
  };
  const auto point = [](const Integers& p) {
    return Point{static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
  };
  for (int n = 0; n < 200000; ++n) {
    Integers p, a, b;
    for (std::size_t k = 0; k < 3; ++k) {
      p[k] = static_cast<std::int64_t>(random.bits() >> 11);
      a[k] = static_cast<std::int64_t>(random.bits() >> 12) * 8;
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int64_t other = p[k] + a[(k + 1) % 3] - p[(k + 1) % 3];
      b[k] = other / 8 * 8 + 8 * static_cast<std::int64_t>(random.below(3));
    }
    const Uint128 to_a = squared(p, a);
    const Uint128 to_b = squared(p, b);
    const Sign expected = to_a < to_b ? Sign::negative : to_a > to_b ? Sign::positive : Sign::zero;
    ASSERT_EQ(compare_distance(point(p), point(a), point(b)), expected) << n;
  }
}

}  // namespace
}  // namespace cocoon
