// Four numbers of about 106 bits that are computed with at once: each the sum of two doubles, for
// determinants whose sign four doubles cannot tell. The same bits on every instruction set. It
// opens its namespaces itself: include it after hwy/foreach_target.h, outside of any.
//
// How large the errors are. Say of a number that its higher part is at most H, the lower one at
// most a u H, and the error at most e u^2 H, u = 2^-53. Then, up to factors (1 + u)^k, and barring
// over- and underflow,
//   difference of doubles at most H apart:  a = 1,  e = 0
//   product, of H1 H2:  a = 1 + a1 + a2,  e = e1 + e2 + a1 a2 + 2 + a1 + 2 a2
//   sum or difference, of H1 + H2:  a = 1 + max(a1, a2),  e = max(e1, e2) + 1 + 2 max(a1, a2)
// since the error of a product or sum of doubles is a double, at most u of it, and what is rounded
// or left out is of second order. Lower parts are not brought below half a unit of the higher ones:
// errors are compared with H, not with the value, and a determinant may be far below it anyway.
//
// Source: for the errors of products and sums that are doubles, Dekker 1971 and Knuth's TwoSum; the
// same in relative terms, Joldes, Muller and Popescu 2017 (docs/bibliography.md).
#if defined(COCOON_DOUBLE_WORDS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef COCOON_DOUBLE_WORDS_INL_H
#undef COCOON_DOUBLE_WORDS_INL_H
#else
#define COCOON_DOUBLE_WORDS_INL_H
#endif

#include "geom/lanes/four_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace cocoon::HWY_NAMESPACE {

struct FourWide {
  Four high, low;
};

// Four points or vectors of space, one axis per member.
struct FourWideVectors {
  FourWide x, y, z;
};

// Exact: the rounded result, and what it leaves out.
HWY_INLINE FourWide wide_sum(const Four& a, const Four& b) {
  const Four high = a + b;
  const Four b_part = high - a;
  return {high, (a - (high - b_part)) + (b - b_part)};
}
HWY_INLINE FourWide wide_difference(const Four& a, const Four& b) {
  const Four high = a - b;
  const Four b_part = a - high;
  return {high, (a - (high + b_part)) + (b_part - b)};
}
HWY_INLINE FourWideVectors wide_difference(const FourVectors& a, const FourVectors& b) {
  return {wide_difference(a.x, b.x), wide_difference(a.y, b.y), wide_difference(a.z, b.z)};
}

HWY_INLINE FourWide operator*(const FourWide& a, const FourWide& b) {
  const Four high = a.high * b.high;
  const Four error = multiply_subtract(a.high, b.high, high);
  return {high, multiply_add(a.low, b.high, multiply_add(a.high, b.low, error))};
}
HWY_INLINE FourWide operator+(const FourWide& a, const FourWide& b) {
  const FourWide high = wide_sum(a.high, b.high);
  return {high.high, high.low + (a.low + b.low)};
}
HWY_INLINE FourWide operator-(const FourWide& a, const FourWide& b) {
  const FourWide high = wide_difference(a.high, b.high);
  return {high.high, high.low + (a.low - b.low)};
}

template <int by>
HWY_INLINE FourWide rotate(const FourWide& a) {
  return {rotate<by>(a.high), rotate<by>(a.low)};
}
template <int by>
HWY_INLINE FourWideVectors rotate(const FourWideVectors& v) {
  return {rotate<by>(v.x), rotate<by>(v.y), rotate<by>(v.z)};
}
HWY_INLINE FourWide squared_norm(const FourWideVectors& v) {
  return v.x * v.x + v.y * v.y + v.z * v.z;
}
HWY_INLINE FourWide minor_xy(const FourWideVectors& v, const FourWideVectors& w) {
  return v.x * w.y - v.y * w.x;
}
// a x - b y + c z
HWY_INLINE FourWide alternating_sum(const FourWide& a, const FourWide& x, const FourWide& b,
                                    const FourWide& y, const FourWide& c, const FourWide& z) {
  return a * x - b * y + c * z;
}

}  // namespace cocoon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
