#include "geom/exact/exact_integer.h"

#include <boost/multiprecision/cpp_int.hpp>
#include <gtest/gtest.h>
#include <limits>
#include <random>

namespace cocoon {
namespace {

using Integer = boost::multiprecision::cpp_int;

template <std::size_t N>
Integer value_of(const ExactInteger<N>& a) {
  Integer value = 0;
  for (std::size_t i = N; i-- > 0;) value = (value << 64) + a.limbs[i];
  return a.is_negative() ? Integer(value - (Integer(1) << (64 * N))) : value;
}

// Limbs that carry: all zeros, all ones, a top bit, or random.
template <std::size_t N>
ExactInteger<N> random_integer(std::mt19937_64& random) {
  ExactInteger<N> a;
  for (std::uint64_t& limb : a.limbs) {
    const std::uint64_t choice = random() % 4;
    limb = choice == 0 ? 0 : choice == 1 ? ~std::uint64_t{0} : random();
  }
  // One bit of headroom, so that sums do not wrap.
  a.limbs[N - 1] = static_cast<std::uint64_t>(static_cast<std::int64_t>(a.limbs[N - 1]) >> 1);
  return a;
}

template <std::size_t N, std::size_t M>
void expect_exact_arithmetic() {
  std::mt19937_64 random(1);
  for (int i = 0; i < 2000; ++i) {
    const ExactInteger<N> a = random_integer<N>(random);
    const ExactInteger<N> b = random_integer<N>(random);
    const ExactInteger<M> c = random_integer<M>(random);
    ASSERT_EQ(value_of(a + b), value_of(a) + value_of(b));
    ASSERT_EQ(value_of(a - b), value_of(a) - value_of(b));
    ASSERT_EQ(value_of(a * c), value_of(a) * value_of(c));
    ASSERT_EQ(static_cast<int>(sign_of(a)), value_of(a).sign());
  }
}

TEST(ExactInteger, AgreesWithIntegersOfAnySize) {
  expect_exact_arithmetic<1, 1>();
  expect_exact_arithmetic<2, 1>();
  expect_exact_arithmetic<2, 4>();
  expect_exact_arithmetic<6, 4>();
  expect_exact_arithmetic<7, 33>();
}

TEST(ExactInteger, SignOfZeroAndOne) {
  ExactInteger<3> a;
  EXPECT_EQ(sign_of(a), Sign::zero);
  a.limbs[0] = 1;
  EXPECT_EQ(sign_of(a), Sign::positive);
  EXPECT_EQ(sign_of(ExactInteger<3>{} - a), Sign::negative);
}

TEST(TakeApart, PutsEveryDoubleTogetherAgain) {
  std::mt19937_64 random(2);
  for (int i = 0; i < 10000; ++i) {
    const double x = std::bit_cast<double>(random());
    if (!std::isfinite(x)) continue;
    const DyadicDouble parts = take_apart(x);
    const double magnitude = std::ldexp(static_cast<double>(parts.mantissa), parts.exponent);
    ASSERT_EQ(parts.negative ? -magnitude : magnitude, x);
    ASSERT_EQ(parts.mantissa % 2, 1U);
  }
  EXPECT_EQ(take_apart(0x1p-1074).exponent, -1074);
  EXPECT_EQ(take_apart(-0.0).mantissa, 0U);
  EXPECT_EQ(take_apart(12).mantissa, 3U);
  EXPECT_EQ(take_apart(12).exponent, 2);
}

// Differences are right although the coordinates themselves do not fit.
TEST(OnGrid, WrapsConsistently) {
  const double x = 0x1p100 + 0x1p60;
  const double y = 0x1p100;
  EXPECT_EQ(value_of(on_grid<1>(x, 0) - on_grid<1>(y, 0)), Integer(1) << 60);
  EXPECT_EQ(value_of(on_grid<1>(y, 0) - on_grid<1>(x, 0)), -(Integer(1) << 60));
  EXPECT_EQ(value_of(on_grid<2>(-3.5, -1)), -7);
  const double largest = std::numeric_limits<double>::max();
  EXPECT_EQ(value_of(on_grid<33>(largest, -1074)), Integer(largest) << 1074);
}

TEST(Rounded, IsTheNearestDouble) {
  std::mt19937_64 random(3);
  for (int i = 0; i < 5000; ++i) {
    const ExactInteger<4> a = random_integer<4>(random);
    const ScaledDouble r = rounded(a);
    // The error is at most half a unit of the 53-bit mantissa.
    const Integer back = Integer(std::ldexp(r.value, -11)) << (r.exponent + 11 + 200);
    const Integer error = abs(Integer((value_of(a) << 200) - back));
    if (sign_of(a) == Sign::zero) continue;
    ASSERT_LE(error, Integer(1) << (r.exponent + 10 + 200));
  }
  ExactInteger<2> tie;
  tie.limbs = {1, (std::uint64_t{1} << 53) + 1};  // a tie but for the last bit: must round up
  EXPECT_EQ(std::ldexp(rounded(tie).value, rounded(tie).exponent - 64), 0x1p53 + 2);
}

}  // namespace
}  // namespace cocoon
