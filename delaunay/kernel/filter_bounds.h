// How large the errors of the determinants are that the kernel computes in SIMD lanes, and for
// which points there are none.
#pragma once

namespace cocoon {

// The lanes compute what insphere_filter and orient3d_filter do, but round only once where a
// product is added: each error that is missing can only tighten the bounds that are derived there.
//
// The filters of the lanes bound X, Y, Z, the largest |difference| on each axis, by the root of L,
// the largest squared length, which is at hand: sqrt(L) (1 + 2 u) is at least each, u = 2^-53. So
// by the derivations in geom/insphere.h and geom/orient3d.h the errors are below 384.02 u L^(5/2)
// and 48.02 u L^(3/2). What is compared are squares, value^2 > coefficient L^5 + smallest; rounding
// them costs less than 8 u, for which 385 and 49 have room. If L overflows, or its power does, the
// bound is infinite and decides nothing; if it does not, neither does the value. If L is so small,
// below 2^-180, that underflow might count, |value| is below 24.1 L^(5/2) or 6.1 L^(3/2), and its
// square below `smallest`.
constexpr double square(double a) { return a * a; }
inline constexpr double insphere_coefficient = square(385 * 0x1p-53);
inline constexpr double insphere_smallest = 0x1p-890;
inline constexpr double orient3d_coefficient = square(49 * 0x1p-53);
inline constexpr double orient3d_smallest = 0x1p-534;

// The second filter of insphere computes in pairs of doubles (geom/lanes/double_words-inl.h). In
// the notation there, with R = sqrt(L) (1 + 2 u):
//   differences (H = R)            a = 1    e = 0
//   squared lengths (R^2)          a = 5    e = 22
//   2 x 2 minors (2 R^2)           a = 4    e = 13
//   3 x 3 minors (6 R^3)           a = 8    e = 56
//   their products (6 R^5)         a = 14   e = 141
//   the sum of four (24 R^5)       a = 16   e = 201
// so the error is below 4825 u^2 L^(5/2); the last rounding, of both parts to one double, is
// relative to the value. 2^13 has room for that and for the square. An underflow anywhere is below
// 2^-1070 max(1, R^3), which is nothing beside u^2 R^5 if L is at least 2^-180; if it is not, the
// square of the value is again below `insphere_smallest`.
inline constexpr double wide_insphere_coefficient = square(0x1p13 * 0x1p-106);

// Up to which largest squared length, of points relative to the one that is tested, a determinant
// of insphere tells all.
struct ExactReaches {
  double filter = -1;  // the first filter's value is exact
  double wide = -1;    // the second filter's value is certain if it is not zero
};

// If all coordinates are multiples of `unit`, so are the differences, and every intermediate value
// of the determinant is an integer multiple of a power of it. The largest, the sums of the four
// summands, stay below 24 L^(5/2), so they are exact up to 2^53 unit^5: for L <= 2^19 unit^2 they
// are below 2^(47.5 + 4.6) unit^5. In pairs of doubles the error, 2^(13 - 106) L^(5/2), is below
// 2^-5 unit^5 for L <= 2^35 unit^2: a value that is not zero is at least unit^5, beyond doubt.
// Negative, so that nothing is exact, if there is no unit, or one so extreme that powers of it, or
// the bound of the second filter, L^5 <= 2^175 unit^10, may under- or overflow.
inline ExactReaches exact_reaches(double unit) {
  if (!(unit > 0x1p-80 && unit < 0x1p80)) return {};
  return {0x1p19 * (unit * unit), 0x1p35 * (unit * unit)};
}

}  // namespace cocoon
