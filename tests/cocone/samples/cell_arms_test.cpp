#include "cocone/samples/cell_arms.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <gtest/gtest.h>

#include "cocone/samples/double_cone.h"
#include "tests/cocone/sample_shapes.h"
#include "tests/cocone/stages.h"

namespace cocoon {
namespace {

// Bit for bit what is computed one by one.
void expect_same_as_one_by_one(const Stages& s, double squared_cosine) {
  CellBlock block;
  ArmSides arms;
  ArmWords words;
  const std::size_t finite = s.triangulation.num_finite_cells();
  for (std::size_t first = 0; first < finite; first += 100) {
    const std::size_t count = std::min<std::size_t>(100, finite - first);
    load_run(s.triangulation, s.dual, CellId(first), count, block);
    arm_words(CellId(first), block, words);
    arm_sides(s.triangulation, s.poles.normals, squared_cosine, CellId(first), block, arms);
    for (std::size_t k = 0; k < count; ++k) {
      for (std::size_t j = 0; j < 4; ++j) {
        const CellId c(first + k);
        const VertexId p = s.triangulation.cell(c).vertices[j];
        const Vec3 arm = s.dual.centers[c] - s.triangulation.point(p);
        const auto rounded = static_cast<float>(squared_norm(arm));
        EXPECT_EQ(words.at(k, j) >> 32, std::uint64_t{std::bit_cast<std::uint32_t>(rounded)} + 1);
        EXPECT_EQ(words.at(k, j) & 0xFFFFFFFFU, c.value);
        const double safe = largest_safe_length * largest_safe_length;
        EXPECT_EQ((arms.unsafe[k] >> j) & 1, squared_norm(arm) < safe ? 0 : 1);
        if (((arms.unsafe[k] >> j) & 1) != 0) continue;
        const ConeSide side = cone_side(arm, s.poles.normals[p], squared_cosine);
        EXPECT_EQ(arms.lower.at(k, j), dot(arm, s.poles.normals[p]) < 0 ? squared_norm(arm) : 0.0);
        EXPECT_EQ((arms.nappes[k] >> j) & 1, side == ConeSide::below ? 1 : 0);
        EXPECT_EQ((arms.nappes[k] >> (4 + j)) & 1, side == ConeSide::above ? 1 : 0);
      }
    }
  }
}

TEST(CellArms, AreThoseComputedOneByOne) {
  expect_same_as_one_by_one(Stages(shapes::random_torus(1000, 0.4, 8)), 0.15);
  expect_same_as_one_by_one(Stages(shapes::random_cube(500, 5)), 0.15);
}

TEST(CellArms, FarCentersAreLeftOut) {
  // Four of them are coplanar up to the last bit.
  expect_same_as_one_by_one(
      Stages({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 1e-200}, {0.3, 0.4, 1}}), 0.15);
}

}  // namespace
}  // namespace cocoon
