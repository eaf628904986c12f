// Four doubles that are computed with at once, for code that is compiled once for each instruction
// set: 256-bit vectors where there are any, else arrays. The same operations in the same order, so
// the same bits everywhere. It opens its namespaces itself: include it after hwy/foreach_target.h,
// outside of any.
#if defined(COCOON_FOUR_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef COCOON_FOUR_LANES_INL_H
#undef COCOON_FOUR_LANES_INL_H
#else
#define COCOON_FOUR_LANES_INL_H
#endif

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace cocoon::HWY_NAMESPACE {

#if HWY_ARCH_X86 && HWY_TARGET <= HWY_AVX2  // AVX2 and better

namespace hn = hwy::HWY_NAMESPACE;
using FourTag = hn::FixedTag<double, 4>;
using Four = hn::Vec<FourTag>;

// Four points or vectors of space, one axis per member.
struct FourVectors {
  Four x, y, z;
};

HWY_INLINE Four broadcast(double value) { return hn::Set(FourTag(), value); }
// a b + c, a b - c, c - a b, rounded once.
HWY_INLINE Four multiply_add(Four a, Four b, Four c) { return hn::MulAdd(a, b, c); }
HWY_INLINE Four multiply_subtract(Four a, Four b, Four c) { return hn::MulSub(a, b, c); }
HWY_INLINE Four subtract_product(Four c, Four a, Four b) { return hn::NegMulAdd(a, b, c); }
HWY_INLINE Four larger(Four a, Four b) { return hn::Max(a, b); }
HWY_INLINE void store(Four a, double* to) { hn::StoreU(a, FourTag(), to); }
HWY_INLINE double first_lane(Four a) { return hn::GetLane(a); }

// (a0, -a1, a2, -a3)
HWY_INLINE Four alternate_signs(Four a) {
  alignas(32) static constexpr double signs[4] = {0.0, -0.0, 0.0, -0.0};
  return hn::Xor(a, hn::Load(FourTag(), signs));
}

// A condition in each lane; comparisons with NaN are false.
using FourMask = hn::Mask<FourTag>;
HWY_INLINE FourMask greater(Four a, Four b) { return hn::Gt(a, b); }
HWY_INLINE FourMask equal(Four a, Four b) { return hn::Eq(a, b); }
HWY_INLINE FourMask both(FourMask a, FourMask b) { return hn::And(a, b); }
HWY_INLINE FourMask either(FourMask a, FourMask b) { return hn::Or(a, b); }
HWY_INLINE Four choose(FourMask mask, Four yes, Four no) { return hn::IfThenElse(mask, yes, no); }
// Bit i: lane i.
HWY_INLINE unsigned bits_of(FourMask mask) {
  std::array<std::uint8_t, 8> bytes;  // StoreMaskBits may write this many
  hn::StoreMaskBits(FourTag(), mask, bytes.data());
  return bytes[0] & 0xFU;
}

// Lane i of the result is lane (i + by) mod 4.
template <int by>
HWY_INLINE Four rotate(Four a) {
  static_assert(by >= 1 && by <= 3);
  const Four by_2 = hn::SwapAdjacentBlocks(a);
  if constexpr (by == 1) return hn::CombineShiftRightBytes<8>(FourTag(), by_2, a);
  if constexpr (by == 2) return by_2;
  return hn::CombineShiftRightBytes<8>(FourTag(), a, by_2);
}

// For each set of lanes of four 32-bit elements the byte shuffle that brings them to the front.
struct FrontShuffles {
  alignas(16) std::uint8_t bytes[16][16];
};
constexpr FrontShuffles make_front_shuffles() {
  FrontShuffles shuffles{};
  for (unsigned which = 0; which < 16; ++which) {
    unsigned count = 0;
    for (unsigned i = 0; i < 4; ++i) {
      if (((which >> i) & 1U) == 0) continue;
      for (unsigned k = 0; k < 4; ++k) {
        shuffles.bytes[which][4 * count + k] = static_cast<std::uint8_t>(4 * i + k);
      }
      ++count;
    }
  }
  return shuffles;
}
inline constexpr FrontShuffles front_shuffles = make_front_shuffles();

// Appends element i of four, shifted right, to `to` for each bit i of `which`, and returns how
// many. May write four.
template <int shift = 0>
HWY_INLINE std::size_t append(const std::uint32_t* four, unsigned which, std::uint32_t* to) {
  const hn::FixedTag<std::uint8_t, 16> bytes;
  const hn::FixedTag<std::uint32_t, 4> d;
  const auto shuffle = hn::Load(bytes, front_shuffles.bytes[which]);
  const auto shifted = hn::ShiftRight<shift>(hn::LoadU(d, four));
  const auto packed = hn::TableLookupBytes(hn::BitCast(bytes, shifted), shuffle);
  hn::StoreU(hn::BitCast(d, packed), d, to);
  return static_cast<std::size_t>(std::popcount(which));
}

HWY_INLINE FourVectors transposed(Four v0, Four v1, Four v2, Four v3) {
  const FourTag d;
  const Four low01 = hn::InterleaveLower(d, v0, v1);   // x0 x1 z0 z1
  const Four high01 = hn::InterleaveUpper(d, v0, v1);  // y0 y1
  const Four low23 = hn::InterleaveLower(d, v2, v3);
  const Four high23 = hn::InterleaveUpper(d, v2, v3);
  return {hn::ConcatLowerLower(d, low23, low01), hn::ConcatLowerLower(d, high23, high01),
          hn::ConcatUpperUpper(d, low23, low01)};
}

// Reads four doubles at each address; the fourth is not used.
HWY_INLINE FourVectors load_points(const double* p0, const double* p1, const double* p2,
                                   const double* p3) {
  const FourTag d;
  return transposed(hn::LoadU(d, p0), hn::LoadU(d, p1), hn::LoadU(d, p2), hn::LoadU(d, p3));
}

#else

struct Four {
  std::array<double, 4> lane;
};

struct FourVectors {
  Four x, y, z;
};

template <class F>
HWY_INLINE Four in_each_lane(F f) {
  return {{f(0U), f(1U), f(2U), f(3U)}};
}
HWY_INLINE Four operator+(const Four& a, const Four& b) {
  return in_each_lane([&](unsigned i) { return a.lane[i] + b.lane[i]; });
}
HWY_INLINE Four operator-(const Four& a, const Four& b) {
  return in_each_lane([&](unsigned i) { return a.lane[i] - b.lane[i]; });
}
HWY_INLINE Four operator*(const Four& a, const Four& b) {
  return in_each_lane([&](unsigned i) { return a.lane[i] * b.lane[i]; });
}
HWY_INLINE Four multiply_add(const Four& a, const Four& b, const Four& c) {
  return in_each_lane([&](unsigned i) { return std::fma(a.lane[i], b.lane[i], c.lane[i]); });
}
HWY_INLINE Four multiply_subtract(const Four& a, const Four& b, const Four& c) {
  return in_each_lane([&](unsigned i) { return std::fma(a.lane[i], b.lane[i], -c.lane[i]); });
}
HWY_INLINE Four subtract_product(const Four& c, const Four& a, const Four& b) {
  return in_each_lane([&](unsigned i) { return std::fma(-a.lane[i], b.lane[i], c.lane[i]); });
}
HWY_INLINE Four broadcast(double value) { return {{value, value, value, value}}; }
HWY_INLINE Four larger(const Four& a, const Four& b) {
  return in_each_lane([&](unsigned i) { return std::max(a.lane[i], b.lane[i]); });
}
HWY_INLINE void store(const Four& a, double* to) { std::copy(a.lane.begin(), a.lane.end(), to); }
HWY_INLINE double first_lane(const Four& a) { return a.lane[0]; }
HWY_INLINE Four alternate_signs(const Four& a) {
  return {{a.lane[0], -a.lane[1], a.lane[2], -a.lane[3]}};
}
using FourMask = std::array<bool, 4>;
template <class F>
HWY_INLINE FourMask mask_of_lanes(F f) {
  return {f(0U), f(1U), f(2U), f(3U)};
}
HWY_INLINE FourMask greater(const Four& a, const Four& b) {
  return mask_of_lanes([&](unsigned i) { return a.lane[i] > b.lane[i]; });
}
HWY_INLINE FourMask equal(const Four& a, const Four& b) {
  return mask_of_lanes([&](unsigned i) { return a.lane[i] == b.lane[i]; });
}
HWY_INLINE FourMask both(const FourMask& a, const FourMask& b) {
  return mask_of_lanes([&](unsigned i) { return a[i] && b[i]; });
}
HWY_INLINE FourMask either(const FourMask& a, const FourMask& b) {
  return mask_of_lanes([&](unsigned i) { return a[i] || b[i]; });
}
HWY_INLINE Four choose(const FourMask& mask, const Four& yes, const Four& no) {
  return in_each_lane([&](unsigned i) { return mask[i] ? yes.lane[i] : no.lane[i]; });
}
HWY_INLINE unsigned bits_of(const FourMask& mask) {
  unsigned bits = 0;
  for (unsigned i = 0; i < 4; ++i) bits |= (mask[i] ? 1U : 0U) << i;
  return bits;
}
template <int by>
HWY_INLINE Four rotate(const Four& a) {
  return in_each_lane([&](unsigned i) { return a.lane[(i + by) % 4]; });
}
template <int shift = 0>
HWY_INLINE std::size_t append(const std::uint32_t* four, unsigned which, std::uint32_t* to) {
  std::size_t count = 0;
  for (unsigned i = 0; i < 4; ++i) {
    to[count] = four[i] >> shift;
    count += (which >> i) & 1U;
  }
  return count;
}
HWY_INLINE FourVectors load_points(const double* p0, const double* p1, const double* p2,
                                   const double* p3) {
  return {{{p0[0], p1[0], p2[0], p3[0]}},
          {{p0[1], p1[1], p2[1], p3[1]}},
          {{p0[2], p1[2], p2[2], p3[2]}}};
}
#endif

HWY_INLINE FourVectors operator-(const FourVectors& a, const FourVectors& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
HWY_INLINE Four squared_norm(const FourVectors& v) {
  return multiply_add(v.x, v.x, multiply_add(v.y, v.y, v.z * v.z));
}
HWY_INLINE Four minor_xy(const FourVectors& v, const FourVectors& w) {
  return multiply_subtract(v.x, w.y, v.y * w.x);
}
// a x - b y + c z
HWY_INLINE Four alternating_sum(const Four& a, const Four& x, const Four& b, const Four& y,
                                const Four& c, const Four& z) {
  return multiply_add(a, x, subtract_product(c * z, b, y));
}
HWY_INLINE unsigned is_greater(const Four& a, const Four& b) { return bits_of(greater(a, b)); }
template <int by>
HWY_INLINE FourVectors rotate(const FourVectors& v) {
  return {rotate<by>(v.x), rotate<by>(v.y), rotate<by>(v.z)};
}

}  // namespace cocoon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
