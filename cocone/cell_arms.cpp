#include "cocone/cell_arms.h"

#include <algorithm>

#include "cocone/double_cone.h"

// Compile everything between HWY_BEFORE_NAMESPACE and HWY_AFTER_NAMESPACE once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "cocone/cell_arms.cpp"
#include <hwy/foreach_target.h>
// clang-format off: must come after foreach_target.h
#include <hwy/highway.h>

#include "geom/vector_lanes-inl.h"
// clang-format on

HWY_BEFORE_NAMESPACE();
namespace cocoon::HWY_NAMESPACE {

void squared_arms(const CellBlock& block, SquaredArms& arms) {
  const Lanes d;
  for (std::size_t b = 0; b < block.used().size(); ++b) {
    const CircumcenterBatch& batch = block.batches[b];
    for (std::size_t first = 0; first < circumcenter_batch_size; first += hn::Lanes(d)) {
      const Vectors centers = load(batch.centers, first);
      for (std::size_t j = 0; j < 4; ++j) {
        const Vectors arm = minus(centers, load(batch.corners[j], first));
        hn::Store(dot(arm, arm), d, &arms.lengths[b][j][first]);
      }
    }
  }
}

using NormalBatches =
    std::array<std::array<BatchOfPoints, 4>, max_block_cells / circumcenter_batch_size>;

void sides_of_batches(const CellBlock& block, const NormalBatches& normals, double squared_cosine,
                      ArmSides& arms) {
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
        const Vector along = dot(arm, load(normals[b][j], first));
        const Vector squared = dot(arm, arm);
        const auto in_nappe = hn::Gt(hn::Mul(along, along), hn::Mul(cosine, squared));
        const auto positive = hn::Gt(along, zero);
        const auto safe = hn::And(hn::Lt(squared, most), hn::Gt(squared, least));
        const auto is_lower = hn::And(hn::Lt(along, zero), safe);
        hn::Store(hn::IfThenElseZero(is_lower, squared), d, &arms.lower.lengths[b][j][first]);
        nappes |= bits_of(hn::AndNot(positive, in_nappe)) << (8 * j + first);
        nappes |= bits_of(hn::And(positive, in_nappe)) << (8 * (4 + j) + first);
        unsafe |= bits_of(hn::Not(safe)) << (8 * j + first);
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

HWY_EXPORT(squared_arms);
HWY_EXPORT(sides_of_batches);

void squared_arms(const CellBlock& block, SquaredArms& arms) {
  HWY_DYNAMIC_DISPATCH(squared_arms)(block, arms);
}

void arm_sides(const Triangulation& triangulation, const IdVector<VertexId, Vec3>& normals,
               double squared_cosine, CellId first, const CellBlock& block, ArmSides& arms) {
  alignas(64) std::array<std::array<BatchOfPoints, 4>, max_block_cells / circumcenter_batch_size>
      of_corners;
  const std::size_t end = block.used().size() * circumcenter_batch_size;
  for (std::size_t k = 0; k < end; ++k) {
    const Cell& cell = triangulation.cell(CellId(first.index() + std::min(k, block.size - 1)));
    auto& batch = of_corners[k / circumcenter_batch_size];
    const std::size_t lane = k % circumcenter_batch_size;
    for (std::size_t j = 0; j < 4; ++j) {
      const Vec3& normal = normals[cell.vertices[j]];
      batch[j][0][lane] = normal.x;
      batch[j][1][lane] = normal.y;
      batch[j][2][lane] = normal.z;
    }
  }
  HWY_DYNAMIC_DISPATCH(sides_of_batches)(block, of_corners, squared_cosine, arms);
}

}  // namespace cocoon

#endif  // HWY_ONCE
