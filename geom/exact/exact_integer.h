// Signed integers of a fixed number of 64-bit limbs, for the exact levels of the predicates.
//
// Two's complement, no allocation, no branch on values. Sums keep the width of their operands and
// wrap; whoever uses them proves that the true value fits (see geom/exact/exact_determinants.h).
// Products have the sum of the widths and are always exact.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "geom/sign.h"

namespace cocoon {

__extension__ using Uint128 = unsigned __int128;

template <std::size_t N>
struct ExactInteger {
  std::array<std::uint64_t, N> limbs{};  // least significant first

  bool is_negative() const { return (limbs[N - 1] >> 63) != 0; }
};

template <std::size_t N>
ExactInteger<N> operator+(const ExactInteger<N>& a, const ExactInteger<N>& b) {
  ExactInteger<N> sum;
  Uint128 carry = 0;
  for (std::size_t i = 0; i < N; ++i) {
    carry += static_cast<Uint128>(a.limbs[i]) + b.limbs[i];
    sum.limbs[i] = static_cast<std::uint64_t>(carry);
    carry >>= 64;
  }
  return sum;
}

template <std::size_t N>
ExactInteger<N> operator-(const ExactInteger<N>& a, const ExactInteger<N>& b) {
  ExactInteger<N> difference;
  std::uint64_t borrow = 0;
  for (std::size_t i = 0; i < N; ++i) {
    const Uint128 d = static_cast<Uint128>(a.limbs[i]) - b.limbs[i] - borrow;
    difference.limbs[i] = static_cast<std::uint64_t>(d);
    borrow = static_cast<std::uint64_t>(d >> 64) & 1U;
  }
  return difference;
}

// Schoolbook multiplication of the limbs as unsigned numbers. A negative operand stands there as
// its value + 2^(64 width): the surplus, the other operand shifted by that width, is taken off.
template <std::size_t N, std::size_t M>
ExactInteger<N + M> operator*(const ExactInteger<N>& a, const ExactInteger<M>& b) {
  ExactInteger<N + M> product;
  for (std::size_t i = 0; i < N; ++i) {
    std::uint64_t carry = 0;
    for (std::size_t j = 0; j < M; ++j) {
      const Uint128 t =
          static_cast<Uint128>(a.limbs[i]) * b.limbs[j] + product.limbs[i + j] + carry;
      product.limbs[i + j] = static_cast<std::uint64_t>(t);
      carry = static_cast<std::uint64_t>(t >> 64);
    }
    product.limbs[i + M] = carry;
  }
  const auto subtract_high = [&product](const auto& limbs, std::size_t shift, std::uint64_t mask) {
    std::uint64_t borrow = 0;
    for (std::size_t i = 0; i < limbs.size(); ++i) {
      const Uint128 d = static_cast<Uint128>(product.limbs[shift + i]) - (limbs[i] & mask) - borrow;
      product.limbs[shift + i] = static_cast<std::uint64_t>(d);
      borrow = static_cast<std::uint64_t>(d >> 64) & 1U;
    }
  };
  subtract_high(b.limbs, N, a.is_negative() ? ~std::uint64_t{0} : 0);
  subtract_high(a.limbs, M, b.is_negative() ? ~std::uint64_t{0} : 0);
  return product;
}

template <std::size_t N>
Sign sign_of(const ExactInteger<N>& a) {
  if (a.is_negative()) return Sign::negative;
  std::uint64_t any = 0;
  for (const std::uint64_t limb : a.limbs) any |= limb;
  return any != 0 ? Sign::positive : Sign::zero;
}

// value * 2^exponent, with |value| in [2^63, 2^64], or zero: the range of double does not hold it.
struct ScaledDouble {
  double value = 0;
  int exponent = 0;
};

// The integer with its mantissa rounded to nearest. The 64 leading bits, the last one set if any
// bit below is, round as the whole number does.
template <std::size_t N>
ScaledDouble rounded(const ExactInteger<N>& a) {
  const bool negative = a.is_negative();
  const ExactInteger<N> magnitude = negative ? ExactInteger<N>{} - a : a;
  std::size_t top = N;
  while (top > 0 && magnitude.limbs[top - 1] == 0) --top;
  if (top == 0) return {};
  const int shift = std::countl_zero(magnitude.limbs[top - 1]);
  std::uint64_t leading = magnitude.limbs[top - 1] << shift;
  std::uint64_t rest = 0;
  if (top > 1) {
    if (shift > 0) leading |= magnitude.limbs[top - 2] >> (64 - shift);
    rest = magnitude.limbs[top - 2] << shift;
  }
  for (std::size_t i = 0; i + 2 < top; ++i) rest |= magnitude.limbs[i];
  if (rest != 0) leading |= 1;
  const double value = static_cast<double>(leading);
  return {negative ? -value : value, 64 * (static_cast<int>(top) - 1) - shift};
}

// A double taken apart: value = (negative ? -1 : 1) * mantissa * 2^exponent, mantissa odd, or zero.
struct DyadicDouble {
  std::uint64_t mantissa = 0;
  int exponent = 0;
  bool negative = false;
};

// `value` must be finite.
inline DyadicDouble take_apart(double value) {
  const auto bits = std::bit_cast<std::uint64_t>(value);
  const int biased = static_cast<int>((bits >> 52) & 0x7FF);
  const std::uint64_t fraction = bits & 0xFFFFFFFFFFFFFULL;
  const std::uint64_t mantissa = biased == 0 ? fraction : fraction | (std::uint64_t{1} << 52);
  if (mantissa == 0) return {};
  const int trailing = std::countr_zero(mantissa);
  return {mantissa >> trailing, (biased == 0 ? 1 : biased) - 1075 + trailing, (bits >> 63) != 0};
}

// value * 2^-unit, modulo 2^(64 N): differences of such integers are right whenever they fit, even
// where the operands do not. Precondition: `unit` is at most the exponent of take_apart(value).
template <std::size_t N>
ExactInteger<N> on_grid(double value, int unit) {
  ExactInteger<N> result;
  const DyadicDouble parts = take_apart(value);
  if (parts.mantissa == 0) return result;
  const auto shift = static_cast<std::size_t>(parts.exponent - unit);
  const std::size_t limb = shift / 64;
  const std::size_t bit = shift % 64;
  if (limb < N) result.limbs[limb] = parts.mantissa << bit;
  if (bit != 0 && limb + 1 < N) result.limbs[limb + 1] = parts.mantissa >> (64 - bit);
  return parts.negative ? ExactInteger<N>{} - result : result;
}

}  // namespace cocoon
