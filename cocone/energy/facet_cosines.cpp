#include "cocone/energy/facet_cosines.h"

#include <limits>

#include "geom/lanes/vector_dispatch.h"

// Compile everything between HWY_BEFORE_NAMESPACE and HWY_AFTER_NAMESPACE once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "cocone/energy/facet_cosines.cpp"
#include <hwy/foreach_target.h>
// clang-format off: must come after foreach_target.h
#include <hwy/highway.h>

#include "geom/lanes/vector_lanes-inl.h"
// clang-format on

HWY_BEFORE_NAMESPACE();
namespace cocoon::HWY_NAMESPACE {

HWY_INLINE Vector norm(const Vectors& a) { return hn::Sqrt(dot(a, a)); }

// The corners of the facet opposite to the k-th of four.
constexpr std::size_t corners_off[4][3] = {{1, 2, 3}, {0, 2, 3}, {0, 1, 3}, {0, 1, 2}};

// The angles at the facets of some cells, in the order of their corners; which cells are flat.
struct Angles {
  Vector opposite[4];
  Mask flat;
};
HWY_INLINE Angles angles_of(const Vectors& center, const Vectors (&corners)[4], double flat_ratio) {
  const Lanes d;
  const Vector zero = hn::Zero(d);
  const Vector one = hn::Set(d, 1.0);
  const Vector infinity = hn::Set(d, std::numeric_limits<double>::infinity());
  const Vector radius = norm(minus(center, corners[0]));
  Angles angles;
  Vector largest = zero;  // twice the area of a facet
  Vector volume = zero;   // six times that of the cell
  for (std::size_t k = 0; k < 4; ++k) {
    const Vectors& p = corners[corners_off[k][0]];
    const Vectors normal =
        cross(minus(corners[corners_off[k][1]], p), minus(corners[corners_off[k][2]], p));
    const Vector area = norm(normal);
    const Vector height = dot(normal, minus(corners[k], p));
    const Mask larger = hn::Gt(area, largest);
    largest = hn::IfThenElse(larger, area, largest);
    volume = hn::IfThenElse(larger, hn::Abs(height), volume);
    const Vector lengths = hn::Mul(area, radius);
    const Mask known = hn::And(hn::Gt(lengths, zero), hn::Lt(lengths, infinity));
    const Vector cosine = hn::Div(dot(normal, minus(center, p)), lengths);
    const Vector inward = hn::IfThenElse(hn::Gt(height, zero), cosine, hn::Neg(cosine));
    const Vector most = hn::IfThenElse(hn::Gt(inward, one), one, inward);
    const Vector least = hn::IfThenElse(hn::Lt(most, hn::Neg(one)), hn::Neg(one), most);
    angles.opposite[k] = hn::IfThenElseZero(known, least);
  }
  const Vector ratio = hn::Set(d, flat_ratio);
  const Vector limit = hn::Mul(hn::Mul(ratio, largest), hn::Sqrt(largest));
  angles.flat = hn::And(hn::Gt(ratio, zero), hn::Le(volume, limit));
  return angles;
}

void cosines_of_batches(const CellBlock& block, double flat_ratio, FacetCosines& result) {
  const Lanes d;
  for (std::size_t b = 0; b < block.used().size(); ++b) {
    const CircumcenterBatch& batch = block.batches[b];
    for (std::size_t first = 0; first < circumcenter_batch_size; first += hn::Lanes(d)) {
      Vectors p[4] = {load(batch.corners[0], first), load(batch.corners[1], first),
                      load(batch.corners[2], first), load(batch.corners[3], first)};
      const Mask swapped_01 = order(p[0], p[1]);
      const Mask swapped_23 = order(p[2], p[3]);
      const Mask swapped_02 = order(p[0], p[2]);
      const Mask swapped_13 = order(p[1], p[3]);
      const Mask swapped_12 = order(p[1], p[2]);
      Angles angles = angles_of(load(batch.centers, first), p, flat_ratio);
      Vector* const at = angles.opposite;  // back to the places of the corners
      swap_if(swapped_12, at[1], at[2]);
      swap_if(swapped_13, at[1], at[3]);
      swap_if(swapped_02, at[0], at[2]);
      swap_if(swapped_23, at[2], at[3]);
      swap_if(swapped_01, at[0], at[1]);
      for (std::size_t k = 0; k < 4; ++k) hn::Store(at[k], d, &result.cosines[b][k][first]);
      std::uint8_t bits[8];  // StoreMaskBits may write this many
      hn::StoreMaskBits(d, angles.flat, bits);
      for (std::size_t i = 0; i < hn::Lanes(d); ++i) {
        result.flat[b * circumcenter_batch_size + first + i] =
            static_cast<std::uint8_t>((bits[0] >> i) & 1U);
      }
    }
  }
}

}  // namespace cocoon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace cocoon {

COCOON_VECTOR_EXPORT(cosines_of_batches);

void facet_cosines(const CellBlock& block, double flat_ratio, FacetCosines& result) {
  COCOON_VECTOR_CALL(cosines_of_batches)(block, flat_ratio, result);
}

}  // namespace cocoon

#endif  // HWY_ONCE
