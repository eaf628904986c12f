#include "cocone/surface_doubts.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "geom/random.h"
#include "tests/cocone/sample_shapes.h"

namespace cocoon {
namespace {

TEST(SurfaceDoubts, NoneOnCleanSurfaces) {
  const std::vector<Point> points = shapes::torus(100, 50, 0.4, 0.5, 1);
  const SurfaceDoubts doubts = surface_doubts(reconstruct_tight(points), points);
  EXPECT_GT(doubts.spacing, 0.03);
  EXPECT_LT(doubts.spacing, 0.1);
  EXPECT_LT(doubts.roughness, 0.05);
  EXPECT_EQ(doubts.boundary_samples, 0U);
  EXPECT_EQ(doubts.fragments + doubts.unused_points + doubts.bad_edges, 0U);
  EXPECT_TRUE(doubts.sparse.empty() && doubts.dust.empty() && doubts.unused.empty());
}

TEST(SurfaceDoubts, RoughnessMeasuresNoise) {
  Random random(2);
  std::vector<Point> points;  // even, with noise of a tenth of the spacing along the normal
  const std::size_t n = 4000;
  const double spacing = std::sqrt(4 * std::numbers::pi / static_cast<double>(n));
  for (std::size_t i = 0; i < n; ++i) {
    const double z = 1 - 2 * (static_cast<double>(i) + 0.5) / static_cast<double>(n);
    const double r = std::sqrt(1 - z * z);
    const double turn = static_cast<double>(i) * 2.399963229728653;
    points.push_back((1 + 0.1 * spacing * random.gaussian()) *
                     Point{r * std::cos(turn), r * std::sin(turn), z});
  }
  const SurfaceDoubts doubts = surface_doubts(reconstruct_tight(points), points);
  EXPECT_NEAR(doubts.roughness, 0.07, 0.02);
}

TEST(SurfaceDoubts, NamesTheWorstSpots) {
  // a sphere without its top; a second, tiny one; a point in the middle
  std::vector<Point> points = shapes::cut_sphere(6000, 0.8, 3);
  points = shapes::joined(points, shapes::sphere(20, 4, 0.05, {3, 0, 0}));
  points.push_back({0, 0, -0.5});
  const ReconstructResult result = reconstruct_tight(points);
  const SurfaceDoubts doubts = surface_doubts(result, points);
  ASSERT_FALSE(doubts.sparse.empty());
  EXPECT_NEAR(doubts.sparse[0].at.z, 0.8, 0.05);
  EXPECT_GT(doubts.sparse[0].size, 4 * doubts.spacing);
  ASSERT_FALSE(doubts.unused.empty());
  EXPECT_EQ(doubts.unused_points, result.unused_points);
  ASSERT_EQ(doubts.fragments, 1U);
  EXPECT_NEAR(doubts.dust[0].at.x, 3, 0.1);
  for (std::size_t k = 1; k < doubts.unused.size(); ++k) {
    EXPECT_GE(doubts.unused[k - 1].size, doubts.unused[k].size);
  }
}

TEST(SurfaceDoubts, EmptyResultsHaveNone) {
  const std::vector<Point> points = shapes::random_cube(30, 5);
  EXPECT_EQ(surface_doubts(ReconstructResult(), points).spacing, 0);
}

TEST(SurfaceDoubts, TheLargestSpotsAreKeptTiesByPlace) {
  const std::vector<DoubtfulSpot> spots = {
      {{2, 0, 0}, 1, 5}, {{1, 0, 0}, 1, 5}, {{0, 0, 0}, 1, 4}, {{3, 0, 0}, 1, 7}};
  std::vector<DoubtfulSpot> kept = spots;
  keep_largest(kept, 2);
  EXPECT_EQ(kept, (std::vector<DoubtfulSpot>{spots[3], spots[1]}));
  kept = spots;
  keep_largest(kept, 9);
  EXPECT_EQ(kept, (std::vector<DoubtfulSpot>{spots[3], spots[1], spots[0], spots[2]}));
}

}  // namespace
}  // namespace cocoon
