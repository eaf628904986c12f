#include "cocone/samples/cell_arms.h"

#include "cocone/samples/double_cone.h"
#include "geom/lanes/vector_dispatch.h"

// Compile everything between HWY_BEFORE_NAMESPACE and HWY_AFTER_NAMESPACE once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "cocone/samples/cell_arms.cpp"
#include <hwy/foreach_target.h>
// clang-format off: must come after foreach_target.h
#include <hwy/highway.h>

#include "geom/lanes/gather-inl.h"
// clang-format on

HWY_BEFORE_NAMESPACE();
namespace cocoon::HWY_NAMESPACE {

void words_of_batches(std::uint32_t first_cell, const CellBlock& block, ArmWords& words) {
  const Lanes d;
  const hn::RebindToUnsigned<Lanes> bits;
  const hn::Rebind<float, Lanes> floats;
  const hn::Rebind<std::uint32_t, Lanes> float_bits;
  auto lower = hn::Iota(bits, (std::uint64_t{1} << 32) + first_cell);
  const auto step = hn::Set(bits, std::uint64_t{hn::Lanes(d)});
  for (std::size_t b = 0; b < block.used().size(); ++b) {
    const CircumcenterBatch& batch = block.batches[b];
    for (std::size_t first = 0; first < circumcenter_batch_size; first += hn::Lanes(d)) {
      const Vectors centers = load(batch.centers, first);
      for (std::size_t j = 0; j < 4; ++j) {
        const Vectors arm = minus(centers, load(batch.corners[j], first));
        const auto rounded = hn::BitCast(float_bits, hn::DemoteTo(floats, dot(arm, arm)));
        const auto upper = hn::ShiftLeft<32>(hn::PromoteTo(bits, rounded));
        hn::Store(hn::Add(upper, lower), bits, &words.words[b][j][first]);
      }
      lower = hn::Add(lower, step);
    }
  }
}

// The normals at corner j of the `lanes` cells from k on; the last cell stands for those behind it.
HWY_INLINE Vectors normals_at(const Vec3* normals, const Cell* cells, std::size_t count,
                              std::size_t k, std::size_t j) {
  return with_places(k, count, [&](auto place) {
    return gather([&](std::size_t i) { return &normals[cells[place(i)].vertices[j].index()].x; });
  });
}

void sides_of_batches(const Cell* cells, const CellBlock& block, const Vec3* normals,
                      double squared_cosine, ArmSides& arms) {
  const Lanes d;
  const Vector zero = hn::Zero(d);
  const Vector cosine = hn::Set(d, squared_cosine);
  const Vector most = hn::Set(d, largest_safe_length * largest_safe_length);
  const Vector least = hn::Set(d, smallest_safe_length * smallest_safe_length);
  for (std::size_t b = 0; b < block.used().size(); ++b) {
    const CircumcenterBatch& batch = block.batches[b];
    std::uint64_t nappes = 0;  // byte j: below at corner j, byte 4 + j: above
    std::uint64_t unsafe = 0;
    for (std::size_t first = 0; first < circumcenter_batch_size; first += hn::Lanes(d)) {
      const Vectors centers = load(batch.centers, first);
      for (std::size_t j = 0; j < 4; ++j) {
        const Vectors arm = minus(centers, load(batch.corners[j], first));
        const Vectors normal =
            normals_at(normals, cells, block.size, b * circumcenter_batch_size + first, j);
        const Vector along = dot(arm, normal);
        const Vector squared = dot(arm, arm);
        const auto in_nappe = hn::Gt(hn::Mul(along, along), hn::Mul(cosine, squared));
        const auto positive = hn::Gt(along, zero);
        const auto safe = hn::And(hn::Lt(squared, most), hn::Gt(squared, least));
        const auto is_lower = hn::And(hn::Lt(along, zero), safe);
        hn::Store(hn::IfThenElseZero(is_lower, squared), d, &arms.lower.lengths[b][j][first]);
        nappes |= std::uint64_t{lane_bits(hn::AndNot(positive, in_nappe))} << (8 * j + first);
        nappes |= std::uint64_t{lane_bits(hn::And(positive, in_nappe))} << (8 * (4 + j) + first);
        unsafe |= std::uint64_t{lane_bits(hn::Not(safe))} << (8 * j + first);
      }
    }
    nappes = transposed_bits(nappes);
    unsafe = unsafe == 0 ? 0 : transposed_bits(unsafe);
    for (std::size_t i = 0; i < circumcenter_batch_size; ++i) {
      arms.nappes[b * circumcenter_batch_size + i] = static_cast<std::uint8_t>(nappes >> (8 * i));
      arms.unsafe[b * circumcenter_batch_size + i] = static_cast<std::uint8_t>(unsafe >> (8 * i));
    }
  }
}

}  // namespace cocoon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace cocoon {

COCOON_VECTOR_EXPORT(words_of_batches);
COCOON_VECTOR_EXPORT(sides_of_batches);

void arm_words(CellId first, const CellBlock& block, ArmWords& words) {
  COCOON_VECTOR_CALL(words_of_batches)(first.value, block, words);
}

void arm_sides(const Triangulation& triangulation, const IdVector<VertexId, Vec3>& normals,
               double squared_cosine, CellId first, const CellBlock& block, ArmSides& arms) {
  COCOON_VECTOR_CALL(sides_of_batches)
  (&triangulation.cell(first), block, normals.raw().data(), squared_cosine, arms);
}

}  // namespace cocoon

#endif  // HWY_ONCE
