#include "cocone/checks/sample_doubts.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <gtest/gtest.h>
#include <utility>
#include <vector>

#include "cocone/boundary_samples.h"
#include "cocone/noise_filter.h"
#include "geom/arrays/median.h"
#include "tests/cocone/sample_shapes.h"
#include "tests/cocone/stages.h"
#include "tests/gallery.h"

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

// The same by asking all samples.
void compare_with_definition(const std::vector<Point>& points, const ReconstructOptions& options,
                             std::size_t max_spots) {
  const SampleDoubts doubts = sample_doubts(points, options, {.max_spots = max_spots});
  const Stages s(points);
  const Cocones cocones = intersect_cocones(s.triangulation, s.dual, s.poles, options.cocone);
  const RadiusMode mode =
      options.mode == Mode::paper ? RadiusMode::cocone : options.boundary.radius_mode;
  const IdVector<VertexId, double> radii =
      cocone_radii(s.triangulation, s.dual, s.poles, cocones, mode);
  const IdVector<VertexId, double> spacing = sample_spacing(s.triangulation, s.stars, 3);
  std::vector<std::pair<double, Point>> ratios;
  std::vector<std::pair<double, Point>> sparse;
  std::vector<double> heights;
  for (const VertexId v : s.triangulation.vertices()) {
    const Point& at = s.triangulation.point(v);
    sparse.emplace_back(-spacing[v], at);
    if (s.poles.heights[v] == 0 || s.poles.degenerate[v] != 0) continue;
    ratios.emplace_back(radii[v] / s.poles.heights[v], at);
    heights.push_back(s.poles.heights[v] / spacing[v]);
  }
  std::sort(sparse.begin(), sparse.end());
  EXPECT_EQ(doubts.height, median(heights));
  EXPECT_EQ(doubts.spacing, median({spacing.begin(), spacing.end()}));
  ASSERT_EQ(doubts.sparse.size(), std::min(max_spots, points.size()));
  for (std::size_t k = 0; k < doubts.sparse.size(); ++k) {
    EXPECT_EQ(doubts.sparse[k].at, sparse[k].second);
    EXPECT_EQ(doubts.sparse[k].size, -sparse[k].first);
    EXPECT_EQ(doubts.sparse[k].count, 1U);
  }
  if (ratios.empty()) {
    EXPECT_TRUE(std::isinf(doubts.least_ratio));
    return;
  }
  const auto least = *std::min_element(ratios.begin(), ratios.end());
  EXPECT_EQ(doubts.least_ratio, least.first);
  if (!std::isfinite(least.first)) return;
  EXPECT_EQ(doubts.best, least.second);
}

// Few samples, most of them without a negative pole; lattices with many ties; flat clouds, at whose
// rims the normals of the hull cancel.
TEST(SampleDoubts, AreThoseOfTheSamples) {
  std::vector<std::vector<Point>> clouds = {shapes::cube_grid(4), shapes::plate(9, 1),
                                            gallery::integer_grid(5),
                                            shapes::dome_patch(9, 0.5, 3)};
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    clouds.push_back(shapes::random_cube(6, seed));
    for (Point& p : clouds.back()) p.z *= 0.1;
    clouds.push_back(shapes::noisy_sphere(100, 0.1, seed));
    clouds.push_back(shapes::random_cube(60, seed));
    for (Point& p : clouds.back()) p.z *= 0.001;
  }
  for (const std::vector<Point>& points : clouds) {
    for (const RadiusMode mode : {RadiusMode::tangent_plane, RadiusMode::cocone}) {
      compare_with_definition(points, {.boundary = {.radius_mode = mode}}, 3);
    }
    compare_with_definition(points, {.mode = Mode::paper}, 2);
    compare_with_definition(
        points, {.cocone = {.cosine = 0.6}, .boundary = {.radius_mode = RadiusMode::cocone}}, 1);
  }
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
