// Vectors from anywhere in memory into SIMD lanes, for code that is compiled once for each
// instruction set. It opens its namespaces itself: include it after hwy/foreach_target.h, outside
// of any.
#if defined(COCOON_GATHER_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef COCOON_GATHER_INL_H
#undef COCOON_GATHER_INL_H
#else
#define COCOON_GATHER_INL_H
#endif

#include <algorithm>
#include <cstddef>
#include <hwy/highway.h>

#include "geom/lanes/four_lanes-inl.h"
#include "geom/lanes/vector_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace cocoon::HWY_NAMESPACE {

#if HWY_ARCH_X86 && HWY_TARGET <= HWY_AVX2  // AVX2 and better

// The three doubles at an address; what follows is not touched.
HWY_INLINE Four load_three(const double* at) {
  const FourTag d;
  return hn::MaskedLoad(hn::FirstN(d, 3), d, at);
}

template <class AddressOf>
HWY_INLINE FourVectors gather_four(AddressOf address_of, std::size_t first) {
  return transposed(load_three(address_of(first)), load_three(address_of(first + 1)),
                    load_three(address_of(first + 2)), load_three(address_of(first + 3)));
}

// Lane i: the three doubles at address_of(i).
template <class AddressOf>
HWY_INLINE Vectors gather(AddressOf address_of) {
  const FourVectors lower = gather_four(address_of, 0);
#if HWY_TARGET <= HWY_AVX3
  const FourVectors upper = gather_four(address_of, 4);
  const Lanes d;
  return {hn::Combine(d, upper.x, lower.x), hn::Combine(d, upper.y, lower.y),
          hn::Combine(d, upper.z, lower.z)};
#else
  return {lower.x, lower.y, lower.z};
#endif
}

#else

template <class AddressOf>
HWY_INLINE Vectors gather(AddressOf address_of) {
  const Lanes d;
  alignas(64) BatchOfPoints points;
  for (std::size_t i = 0; i < hn::Lanes(d); ++i) {
    const double* const at = address_of(i);
    points[0][i] = at[0];
    points[1][i] = at[1];
    points[2][i] = at[2];
  }
  return load(points, 0);
}

#endif

// use(place) for the lanes that hold the elements k, k + 1, ... of `count`: place(i) is that of
// lane i. The last element stands for those behind it.
template <class Use>
HWY_INLINE auto with_places(std::size_t k, std::size_t count, Use use) {
  if (k + hn::Lanes(Lanes()) <= count) [[likely]] {
    return use([k](std::size_t i) { return k + i; });
  }
  return use([k, count](std::size_t i) { return std::min(k + i, count - 1); });
}

}  // namespace cocoon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per target
