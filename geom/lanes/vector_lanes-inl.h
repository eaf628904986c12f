// Points and vectors of a batch in SIMD lanes, one in each, for code that is compiled once for each
// instruction set. The operations round as their namesakes of geom/point.h: the same bits
// everywhere.
#if defined(COCOON_VECTOR_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef COCOON_VECTOR_LANES_INL_H
#undef COCOON_VECTOR_LANES_INL_H
#else
#define COCOON_VECTOR_LANES_INL_H
#endif

#include <cstddef>
#include <cstdint>
#include <hwy/highway.h>

#include "geom/circumsphere_batch.h"

HWY_BEFORE_NAMESPACE();
namespace cocoon::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Lanes = hn::CappedTag<double, circumcenter_batch_size>;
using Vector = hn::Vec<Lanes>;
using Mask = hn::Mask<Lanes>;

// A point or vector in each lane.
struct Vectors {
  Vector x, y, z;
};

// Those from `first` on, a multiple of the number of lanes.
HWY_INLINE Vectors load(const BatchOfPoints& points, std::size_t first) {
  const Lanes d;
  return {hn::Load(d, &points[0][first]), hn::Load(d, &points[1][first]),
          hn::Load(d, &points[2][first])};
}

HWY_INLINE Vectors minus(const Vectors& a, const Vectors& b) {
  return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}
HWY_INLINE Vector dot(const Vectors& a, const Vectors& b) {
  return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
}
// a d - b c
HWY_INLINE Vector minor(Vector a, Vector b, Vector c, Vector d) {
  return hn::Sub(hn::Mul(a, d), hn::Mul(b, c));
}
HWY_INLINE Vectors cross(const Vectors& a, const Vectors& b) {
  return {minor(a.y, a.z, b.y, b.z), minor(a.z, a.x, b.z, b.x), minor(a.x, a.y, b.x, b.y)};
}

HWY_INLINE void store(const Vectors& vectors, BatchOfPoints& points, std::size_t first) {
  const Lanes d;
  hn::Store(vectors.x, d, &points[0][first]);
  hn::Store(vectors.y, d, &points[1][first]);
  hn::Store(vectors.z, d, &points[2][first]);
}

// Bit i: lane i.
HWY_INLINE std::uint32_t lane_bits(Mask mask) {
  std::uint8_t bytes[8];  // StoreMaskBits may write this many
  hn::StoreMaskBits(Lanes(), mask, bytes);
  return bytes[0] & ((1U << hn::Lanes(Lanes())) - 1U);
}

// In lexicographic order.
HWY_INLINE Mask precedes(const Vectors& a, const Vectors& b) {
  const Mask z = hn::Lt(a.z, b.z);
  const Mask yz = hn::Or(hn::Lt(a.y, b.y), hn::And(hn::Eq(a.y, b.y), z));
  return hn::Or(hn::Lt(a.x, b.x), hn::And(hn::Eq(a.x, b.x), yz));
}
HWY_INLINE void swap_if(Mask mask, Vector& a, Vector& b) {
  const Vector before = a;
  a = hn::IfThenElse(mask, b, a);
  b = hn::IfThenElse(mask, before, b);
}
// Puts two points in lexicographic order; where they were not.
HWY_INLINE Mask order(Vectors& a, Vectors& b) {
  const Mask swapped = precedes(b, a);
  swap_if(swapped, a.x, b.x);
  swap_if(swapped, a.y, b.y);
  swap_if(swapped, a.z, b.z);
  return swapped;
}

// Byte i of the result: bit i of each of the eight bytes.
HWY_INLINE std::uint64_t transposed_bits(std::uint64_t bits) {
  const auto swap = [&bits](int distance, std::uint64_t lower) {
    const std::uint64_t differ = (bits ^ (bits >> distance)) & lower;
    bits ^= differ ^ (differ << distance);
  };
  swap(7, 0x00AA00AA00AA00AAU);
  swap(14, 0x0000CCCC0000CCCCU);
  swap(28, 0x00000000F0F0F0F0U);
  return bits;
}

}  // namespace cocoon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per target
