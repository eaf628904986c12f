#include "geom/circumsphere_batch.h"

#include <cstdint>
#include <limits>
#include <span>

// Compile everything between HWY_BEFORE_NAMESPACE and HWY_AFTER_NAMESPACE once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "geom/circumsphere_batch.cpp"
#include <hwy/foreach_target.h>
// clang-format off: must come after foreach_target.h
#include <hwy/highway.h>

#include "geom/vector_lanes-inl.h"
// clang-format on

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

// tetrahedron_in_doubles of circumsphere.cpp, where the bounds are derived, for every lane from
// `first` on.
HWY_INLINE Mask centers_from(const CircumcenterBatch& batch, std::size_t first, Vectors& centers) {
  const Lanes d;
  Vectors p0 = load(batch.corners[0], first), p1 = load(batch.corners[1], first);
  Vectors p2 = load(batch.corners[2], first), p3 = load(batch.corners[3], first);
  order(p0, p1);
  order(p2, p3);
  order(p0, p2);
  order(p1, p3);
  order(p1, p2);
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
  const Vector two = hn::Set(d, 2.0);
  const Vector denominator = hn::Mul(two, dot(u, vw));
  const Vectors numerator = plus(plus(times(uu, vw), times(vv, wu)), times(ww, uv));
  const Vectors offset{hn::Div(numerator.x, denominator), hn::Div(numerator.y, denominator),
                       hn::Div(numerator.z, denominator)};

  const Vectors vw_sum = absolute_cross(v, w);
  const Vector denominator_sum = hn::Mul(two, dot(absolute(u), vw_sum));
  const Vector numerator_sum = largest(plus(
      plus(times(uu, vw_sum), times(vv, absolute_cross(w, u))), times(ww, absolute_cross(u, v))));
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
  // 1 / scale, a power of two as well.
  const Vector enlarge =
      hn::IfThenElse(normal, hn::BitCast(d, hn::ShiftLeft<52>(biased)), hn::Set(d, 1.0));
  centers = plus(p0, times(enlarge, offset));
  const Mask finite = hn::Le(largest(centers), hn::Set(d, std::numeric_limits<double>::max()));
  return hn::And(hn::And(normal, finite), hn::And(sure_denominator, sure_numerator));
}

void certified_centers(std::span<CircumcenterBatch> batches) {
  const Lanes d;
  for (CircumcenterBatch& batch : batches) {
    batch.certified = 0;
    for (std::size_t first = 0; first < circumcenter_batch_size; first += hn::Lanes(d)) {
      Vectors centers;
      const Mask sure = centers_from(batch, first, centers);
      hn::Store(centers.x, d, &batch.centers[0][first]);
      hn::Store(centers.y, d, &batch.centers[1][first]);
      hn::Store(centers.z, d, &batch.centers[2][first]);
      std::uint8_t bytes[8];  // StoreMaskBits may write this many
      hn::StoreMaskBits(d, sure, bytes);
      batch.certified |= (bytes[0] & ((1U << hn::Lanes(d)) - 1U)) << first;
    }
  }
}

}  // namespace cocoon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace cocoon {

HWY_EXPORT(certified_centers);

void circumcenters_in_doubles(std::span<CircumcenterBatch> batches) {
  HWY_DYNAMIC_DISPATCH(certified_centers)(batches);
}

}  // namespace cocoon

#endif  // HWY_ONCE
