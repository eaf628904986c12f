// Circumcenters of tetrahedra in SIMD lanes, for code that is compiled once for each instruction
// set.
#if defined(COCOON_CIRCUMCENTER_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef COCOON_CIRCUMCENTER_LANES_INL_H
#undef COCOON_CIRCUMCENTER_LANES_INL_H
#else
#define COCOON_CIRCUMCENTER_LANES_INL_H
#endif

#include <array>
#include <cstddef>
#include <cstdint>
#include <hwy/highway.h>
#include <limits>

#include "geom/lanes/vector_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace cocoon::HWY_NAMESPACE {

HWY_INLINE Vectors plus(const Vectors& a, const Vectors& b) {
  return {hn::Add(a.x, b.x), hn::Add(a.y, b.y), hn::Add(a.z, b.z)};
}
HWY_INLINE Vectors times(Vector s, const Vectors& a) {
  return {hn::Mul(s, a.x), hn::Mul(s, a.y), hn::Mul(s, a.z)};
}
HWY_INLINE Vectors absolute(const Vectors& a) { return {hn::Abs(a.x), hn::Abs(a.y), hn::Abs(a.z)}; }
HWY_INLINE Vector largest(const Vectors& a) {
  return hn::Max(hn::Max(hn::Abs(a.x), hn::Abs(a.y)), hn::Abs(a.z));
}
HWY_INLINE Vector absolute_minor(Vector a, Vector b, Vector c, Vector d) {
  return hn::Add(hn::Abs(hn::Mul(a, d)), hn::Abs(hn::Mul(b, c)));
}
HWY_INLINE Vectors absolute_cross(const Vectors& a, const Vectors& b) {
  return {absolute_minor(a.y, a.z, b.y, b.z), absolute_minor(a.z, a.x, b.z, b.x),
          absolute_minor(a.x, a.y, b.x, b.y)};
}

// Whether the errors of denominator and offset are as small as tetrahedron_in_doubles wants them.
HWY_INLINE Mask bounds_hold(const Vectors& u, const Vectors& v, const Vectors& w,
                            Vector denominator, const Vectors& offset) {
  const Lanes d;
  const Vectors vw_sum = absolute_cross(v, w);
  const Vector denominator_sum = hn::Mul(hn::Set(d, 2.0), dot(absolute(u), vw_sum));
  const Vector numerator_sum =
      largest(plus(plus(times(dot(u, u), vw_sum), times(dot(v, v), absolute_cross(w, u))),
                   times(dot(w, w), absolute_cross(u, v))));
  const Vector allowed = hn::Mul(hn::Set(d, 0x1p-24), hn::Abs(denominator));
  const Mask sure_denominator =
      hn::And(hn::Gt(hn::Abs(denominator), hn::Set(d, 0x1p-900)),
              hn::Le(hn::Mul(hn::Set(d, 9 * 0x1p-53), denominator_sum), allowed));
  // In squares, with room for their roundings: the root would be waited for.
  const Vector numerator_error = hn::Mul(hn::Set(d, 13 * 0x1p-53), numerator_sum);
  const Vector squared_error =
      hn::Max(hn::Mul(hn::Set(d, 1 + 0x1p-40), hn::Mul(numerator_error, numerator_error)),
              hn::Set(d, 0x1p-900));
  const Mask sure_numerator =
      hn::Lt(squared_error, hn::Mul(hn::Mul(allowed, allowed), dot(offset, offset)));
  return hn::And(sure_denominator, sure_numerator);
}

// Whether the bounds certainly hold, for tetrahedra that are not flat: fewer operations. Let P be
// the product and S the sum of uu, vv, ww. By Cauchy and Schwarz denominator_sum^2 <= 12 P and
// numerator_sum^2 <= 3 P S, and |offset|^2 >= S / 12, since the center is at least half an edge
// away from both ends. So denominator^2 > 2^-44 P leaves
//   (9 2^-53)^2 12 P < 2^-96 P, against 2^-48 denominator^2 > 2^-92 P, and
//   (13 2^-53)^2 3 P S < 2^-97 P S, against 2^-48 denominator^2 |offset|^2 > 2^-95.6 P S:
// room for all roundings, the error of the offset (below 2^-25 sqrt(S)) among them. P is so large
// that nothing underflows.
HWY_INLINE Mask is_far_from_flat(Vector uu, Vector vv, Vector ww, Vector denominator) {
  const Lanes d;
  const Vector product = hn::Mul(hn::Mul(uu, vv), ww);
  return hn::And(hn::Gt(product, hn::Set(d, 0x1p-700)),
                 hn::Gt(hn::Mul(denominator, denominator), hn::Mul(hn::Set(d, 0x1p-44), product)));
}

// Puts two points in the order of their first coordinates.
HWY_INLINE void order_by_x(Vectors& a, Vectors& b) {
  const Mask swapped = hn::Lt(b.x, a.x);
  swap_if(swapped, a.x, b.x);
  swap_if(swapped, a.y, b.y);
  swap_if(swapped, a.z, b.z);
}

template <class Order>
HWY_INLINE void sort_corners(std::array<Vectors, 4>& p, Order order_two) {
  order_two(p[0], p[1]);
  order_two(p[2], p[3]);
  order_two(p[0], p[2]);
  order_two(p[1], p[3]);
  order_two(p[1], p[2]);
}

// The corners in lexicographic order. Coordinates but the first seldom matter.
HWY_INLINE std::array<Vectors, 4> sorted_corners(const std::array<Vectors, 4>& corners) {
  std::array<Vectors, 4> sorted = corners;
  sort_corners(sorted, order_by_x);
  const Mask tied =
      hn::Or(hn::Or(hn::Eq(sorted[0].x, sorted[1].x), hn::Eq(sorted[1].x, sorted[2].x)),
             hn::Eq(sorted[2].x, sorted[3].x));
  if (!hn::AllFalse(Lanes(), tied)) [[unlikely]] {
    sorted = corners;
    sort_corners(sorted, order);
  }
  return sorted;
}

// tetrahedron_in_doubles of circumsphere.cpp, where the bounds are derived, for every lane. Returns
// which centers are certified.
HWY_INLINE Mask circumcenters(const std::array<Vectors, 4>& corners, Vectors& centers) {
  const Lanes d;
  const auto [p0, p1, p2, p3] = sorted_corners(corners);
  const Vectors r1 = minus(p1, p0), r2 = minus(p2, p0), r3 = minus(p3, p0);
  const Vector reach = hn::Max(hn::Max(largest(r1), largest(r2)), largest(r3));

  // scale_for, for normal lengths; the others are not certified here.
  const hn::RebindToUnsigned<Lanes> bits;
  const auto biased = hn::ShiftRight<52>(hn::BitCast(bits, reach));
  const Mask normal = hn::And(hn::Ge(reach, hn::Set(d, std::numeric_limits<double>::min())),
                              hn::Lt(reach, hn::Set(d, 0x1p+1022)));
  const auto opposite = hn::Sub(hn::Set(bits, std::uint64_t{2046}), biased);
  const Vector scale =
      hn::IfThenElse(normal, hn::BitCast(d, hn::ShiftLeft<52>(opposite)), hn::Set(d, 1.0));

  const Vectors u = times(scale, r1), v = times(scale, r2), w = times(scale, r3);
  const Vector uu = dot(u, u), vv = dot(v, v), ww = dot(w, w);
  const Vectors vw = cross(v, w), wu = cross(w, u), uv = cross(u, v);
  const Vector denominator = hn::Mul(hn::Set(d, 2.0), dot(u, vw));
  const Vectors numerator = plus(plus(times(uu, vw), times(vv, wu)), times(ww, uv));
  const Vectors offset{hn::Div(numerator.x, denominator), hn::Div(numerator.y, denominator),
                       hn::Div(numerator.z, denominator)};
  // 1 / scale, a power of two as well.
  const Vector enlarge =
      hn::IfThenElse(normal, hn::BitCast(d, hn::ShiftLeft<52>(biased)), hn::Set(d, 1.0));
  centers = plus(p0, times(enlarge, offset));
  const Mask usual =
      hn::And(normal, hn::Le(largest(centers), hn::Set(d, std::numeric_limits<double>::max())));

  if (hn::AllTrue(d, is_far_from_flat(uu, vv, ww, denominator))) [[likely]]
    return usual;
  return hn::And(usual, bounds_hold(u, v, w, denominator, offset));
}

}  // namespace cocoon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per target
