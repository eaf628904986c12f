#include "cocone/sample_doubts.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "cocone/boundary_samples.h"
#include "tests/cocone/sample_shapes.h"

namespace cocoon {
namespace {

// The rho that it names is the one from which on a sample meets the ratio condition.
TEST(SampleDoubts, LeastRatioIsWhereTheRatioConditionBegins) {
  const std::vector<Point> points = shapes::random_cube(60, 5);
  ReconstructOptions options;
  const SampleDoubts doubts = sample_doubts(points, options);
  ASSERT_TRUE(std::isfinite(doubts.least_ratio));
  EXPECT_NE(std::find(points.begin(), points.end(), doubts.best), points.end());
  options.boundary.alpha_cosine = 0;  // any normals agree
  options.boundary.rho = doubts.least_ratio * (1 - 1e-9);
  EXPECT_EQ(reconstruct_cocone(points, options).status, SurfaceStatus::no_surface);
  options.boundary.rho = doubts.least_ratio * (1 + 1e-9);
  EXPECT_EQ(reconstruct_cocone(points, options).counters.ratio_failed, points.size() - 1);
}

TEST(SampleDoubts, SpacingsAreNamedWhereTheyAreLargest) {
  std::vector<Point> points = shapes::sphere(500, 1);
  points.push_back({9, 0, 0});
  points.push_back({0, -5, 0});
  const SampleDoubts doubts = sample_doubts(points, {}, {.max_spots = 2});
  ASSERT_EQ(doubts.sparse.size(), 2U);
  EXPECT_EQ(doubts.sparse[0].at, (Point{9, 0, 0}));
  EXPECT_EQ(doubts.sparse[1].at, (Point{0, -5, 0}));
  EXPECT_GT(doubts.sparse[0].size, 8);
  EXPECT_NEAR(doubts.spacing, std::sqrt(4 * 3.14159 / 500), 0.06);
}

TEST(SampleDoubts, HeightsTellSurfacesFromVolumes) {
  EXPECT_LT(sample_doubts(shapes::random_cube(500, 2)).height, 2);
  EXPECT_GT(sample_doubts(shapes::sphere(500, 3)).height, 5);
}

TEST(SampleDoubts, UnitsAreThoseOfThePoints) {
  std::vector<Point> points = shapes::random_cube(40, 7);
  const SampleDoubts near = sample_doubts(points);
  for (Point& p : points) p = 0x1p+300 * p;
  const SampleDoubts far = sample_doubts(points);
  EXPECT_EQ(far.spacing, 0x1p+300 * near.spacing);
  EXPECT_EQ(far.best, 0x1p+300 * near.best);
  EXPECT_EQ(far.least_ratio, near.least_ratio);
  EXPECT_EQ(far.sparse[0].size, 0x1p+300 * near.sparse[0].size);
  EXPECT_EQ(far.sparse[0].at, 0x1p+300 * near.sparse[0].at);
}

}  // namespace
}  // namespace cocoon
