#include "cocone/samples/farthest_cells.h"

#include <algorithm>
#include <gtest/gtest.h>

#include "geom/parallel/parallel_fold.h"
#include "tests/cocone/sample_shapes.h"
#include "tests/cocone/stages.h"
#include "tests/gallery.h"

namespace cocoon {
namespace {

constexpr std::size_t block_size = 100;

// One after the other.
CellId farthest_of_star(const Stages& s, VertexId p) {
  CellId best;
  for (const CellId c : s.stars.star(p)) {
    if (s.triangulation.is_infinite(c)) continue;
    if (best.is_none() ||
        arm_of(s.triangulation, s.dual, c, p).precedes(arm_of(s.triangulation, s.dual, best, p))) {
      best = c;
    }
  }
  return best;
}

// Compared by their centers, since cells of cospherical points have the same.
void expect_farthest_of_stars(const Stages& s, const Execution& execution) {
  const FarthestCells farthest = parallel_fold(
      execution, s.triangulation.num_finite_cells(), block_size,
      [&] { return FarthestCells(s.triangulation, s.dual); },
      [&](FarthestCells& part, std::size_t begin, std::size_t end) {
        CellBlock block;
        ArmWords words;
        load_run(s.triangulation, s.dual, CellId(begin), end - begin, block);
        arm_words(CellId(begin), block, words);
        part.offer(CellId(begin), block, words);
      },
      [&](FarthestCells& all, const FarthestCells& others) { all.join(others, execution); });
  for (const VertexId p : s.triangulation.vertices()) {
    EXPECT_EQ(s.dual.centers[farthest.farthest(p)], s.dual.centers[farthest_of_star(s, p)]);
  }
}

// Where many centers are equally far, where some are so far that squares overflow, and elsewhere.
TEST(FarthestCells, AreTheFarthestOfEachStar) {
  const std::vector<std::vector<Point>> sets{
      shapes::random_torus(3000, 0.4, 8),
      gallery::integer_grid(7),
      gallery::integer_sphere(50),
      gallery::ulp_pairs(200),
      {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 1e-200}, {0.3, 0.4, 1}}};
  for (const std::vector<Point>& points : sets) {
    const Stages s(points);
    expect_farthest_of_stars(s, {.threads = 1});
    expect_farthest_of_stars(s, {.threads = 3});
  }
}

}  // namespace
}  // namespace cocoon
