#include "cocone/cell_arms.h"

#include "cocone/double_cone.h"

// Compile everything between HWY_BEFORE_NAMESPACE and HWY_AFTER_NAMESPACE once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "cocone/cell_arms.cpp"
#include <hwy/foreach_target.h>
// clang-format off: must come after foreach_target.h
#include "delaunay/lanes-inl.h"
// clang-format on

HWY_BEFORE_NAMESPACE();
namespace cocoon::HWY_NAMESPACE {

HWY_INLINE FourVectors at_corners(const IdVector<VertexId, Vec3>& vectors, const Cell& cell) {
  const auto& [a, b, c, d] = cell.vertices;
  return load_triples(&vectors[a].x, &vectors[b].x, &vectors[c].x, &vectors[d].x);
}

HWY_INLINE FourVectors arms_of(const Triangulation& triangulation, const Dual& dual, CellId c) {
  const Point& center = dual.centers[c];
  const FourVectors centers{broadcast(center.x), broadcast(center.y), broadcast(center.z)};
  return centers - at_corners(triangulation.points(), triangulation.cell(c));
}

void squared_arms(const Triangulation& triangulation, const Dual& dual, CellId first,
                  std::size_t count, SquaredArms& arms) {
  for (std::size_t k = 0; k < count; ++k) {
    const FourVectors arm = arms_of(triangulation, dual, CellId(first.index() + k));
    store(dot(arm, arm), &arms.lengths[4 * k]);
  }
}

void arm_sides(const Triangulation& triangulation, const Dual& dual,
               const IdVector<VertexId, Vec3>& normals, double squared_cosine, CellId first,
               std::size_t count, ArmSides& arms) {
  const Four zero = broadcast(0);
  const Four cosine = broadcast(squared_cosine);
  const Four most = broadcast(largest_safe_length * largest_safe_length);
  const Four least = broadcast(smallest_safe_length * smallest_safe_length);
  for (std::size_t k = 0; k < count; ++k) {
    const CellId c(first.index() + k);
    const FourVectors arm = arms_of(triangulation, dual, c);
    const Four along = dot(arm, at_corners(normals, triangulation.cell(c)));
    const Four squared = dot(arm, arm);
    const unsigned nappes = is_greater(along * along, cosine * squared);
    const unsigned positive = is_greater(along, zero);
    const unsigned safe = bits_of(both(greater(most, squared), greater(squared, least)));
    store(squared, &arms.squared.lengths[4 * k]);
    arms.negative[k] = static_cast<std::uint8_t>(is_greater(zero, along));
    arms.nappes[k] = static_cast<std::uint8_t>((nappes & ~positive) | (nappes & positive) << 4);
    arms.unsafe[k] = static_cast<std::uint8_t>(15U & ~safe);
  }
}

}  // namespace cocoon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace cocoon {

HWY_EXPORT(squared_arms);
HWY_EXPORT(arm_sides);

void squared_arms(const Triangulation& triangulation, const Dual& dual, CellId first,
                  std::size_t count, SquaredArms& arms) {
  HWY_DYNAMIC_DISPATCH(squared_arms)(triangulation, dual, first, count, arms);
}

void arm_sides(const Triangulation& triangulation, const Dual& dual,
               const IdVector<VertexId, Vec3>& normals, double squared_cosine, CellId first,
               std::size_t count, ArmSides& arms) {
  HWY_DYNAMIC_DISPATCH(arm_sides)
  (triangulation, dual, normals, squared_cosine, first, count, arms);
}

}  // namespace cocoon

#endif  // HWY_ONCE
