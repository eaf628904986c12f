#include "cocone/energy/star_parts.h"

#include <gtest/gtest.h>
#include <vector>

#include "geom/arrays/sort_ids.h"
#include "tests/cocone/random_labeling.h"

namespace cocoon {
namespace {

// Sides of cells that hang together in patches, as on real surfaces: each cell is on the side of
// the half-space or of the noise.
void set_sides(Labeling& labeling, double noise, Random& random) {
  const Triangulation& t = labeling.stages.triangulation;
  const Vec3 normal = random.on_unit_sphere();
  for (const CellId c : t.finite_cells()) {
    Vec3 sum;
    for (const VertexId v : t.cell(c).vertices) sum = sum + t.point(v);
    const bool beyond = dot(sum, normal) > 0.2;
    labeling.out[c] = (random.uniform() < noise ? random.uniform() < 0.5 : beyond) ? 1 : 0;
  }
}

// The number after a flip is that of the flipped sides, by the plainest means; and sides are as
// before.
TEST(StarParts, CountsAfterAFlipAsIfItWereDone) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    Labeling labeling(ball(seed), seed);
    const Triangulation& t = labeling.stages.triangulation;
    StarParts parts(t, labeling.stars, labeling.out);
    const VertexId center = t.vertex_of_point()[PointId(std::size_t{60})];
    ASSERT_TRUE(parts.is_large(center));
    const std::span<const CellId> star = labeling.stars.star(center);
    Random random(seed);
    for (const double noise : {0.0, 0.1, 0.5, 1.0}) {
      set_sides(labeling, noise, random);
      const auto before = labeling.out;
      const std::size_t now = parts.count(center);
      EXPECT_EQ(now, labeling.parts(center));
      for (const CellId c : star) {
        const std::size_t after = parts.count_after(center, {&c, 1}, now);
        EXPECT_TRUE(labeling.out == before);
        labeling.out[c] ^= 1U;
        EXPECT_EQ(after, labeling.parts(center));
        labeling.out[c] ^= 1U;
      }
      for (std::size_t k = 0; k < 200; ++k) {
        std::vector<CellId> cells;
        for (std::size_t i = 0; i <= random.below(4); ++i) {
          cells.push_back(star[random.below(star.size())]);
        }
        make_set(cells);
        const std::size_t after = parts.count_after(center, cells, now);
        for (const CellId c : cells) labeling.out[c] ^= 1U;
        EXPECT_EQ(after, labeling.parts(center));
        for (const CellId c : cells) labeling.out[c] ^= 1U;
      }
    }
  }
}

}  // namespace
}  // namespace cocoon
