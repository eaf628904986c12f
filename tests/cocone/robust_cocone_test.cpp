#include "cocone/robust_cocone.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "cocone/noise/rough_surface.h"
#include "cocone/noise_filter.h"
#include "delaunay/delaunay.h"
#include "delaunay/voronoi_dual.h"
#include "geom/mesh_check.h"
#include "geom/random/random.h"
#include "geom/working_scale.h"
#include "ref/cgal_noise_filter.h"
#include "tests/cocone/sample_shapes.h"
#include "tests/gallery.h"

namespace cocoon {
namespace {

// Each point moved by a normal variable of this deviation on each axis.
std::vector<Point> shaken(std::vector<Point> points, double deviation, std::uint64_t seed) {
  Random random(seed);
  for (Point& p : points) {
    p = p + deviation * Vec3{random.gaussian(), random.gaussian(), random.gaussian()};
  }
  return points;
}

std::vector<Point> scattered(std::size_t count, double size, std::uint64_t seed) {
  std::vector<Point> points = shapes::random_cube(count, seed);
  for (Point& p : points) p = size * (p - Vec3{0.5, 0.5, 0.5});
  return points;
}

std::size_t count_left_out(const RobustSamples& samples, std::size_t begin, std::size_t end) {
  std::size_t count = 0;
  for (std::size_t i = begin; i < end; ++i) count += samples.kept[PointId(i)] == 0 ? 1U : 0U;
  return count;
}

// The others lie 1, 1, 2 and 9 from the origin.
TEST(NoiseFilter, SpacingIsTheRootMeanSquareOfShortEdges) {
  const std::vector<Point> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 2}, {-9, 0, 0}};
  const Triangulation triangulation = delaunay(points).triangulation;
  const VertexStars stars = vertex_stars(triangulation);
  const VertexId origin = triangulation.vertex_of_point()[PointId(0)];
  EXPECT_DOUBLE_EQ(sample_spacing(triangulation, stars, 1)[origin], 1);
  EXPECT_DOUBLE_EQ(sample_spacing(triangulation, stars, 3)[origin], std::sqrt((1 + 1 + 4) / 3.0));
}

// Squares of lengths have no place in a double.
TEST(NoiseFilter, SpacingOfImmenseTriangulationsIsInfinite) {
  const Triangulation triangulation =
      delaunay(gallery::scaled(gallery::even_sphere(20), 0x1p+600)).triangulation;
  for (const double spacing : sample_spacing(triangulation, vertex_stars(triangulation), 3)) {
    EXPECT_TRUE(std::isinf(spacing));
  }
}

TEST(NoiseFilter, CleanSamplesAllStay) {
  for (const auto& points : {shapes::sphere(1500, 1), shapes::random_torus(2500, 0.4, 2),
                             shapes::latitude_sphere(15, 24)}) {
    const RobustResult result = reconstruct_robust(points);
    EXPECT_EQ(result.noise.outliers, 0U);
    EXPECT_EQ(result.noise.layer_samples, 0U);
    const ReconstructResult plain = reconstruct_tight(points);
    EXPECT_EQ(result.surface.mesh, plain.mesh);
    EXPECT_EQ(result.surface.point_of_vertex, plain.point_of_vertex);
    EXPECT_EQ(result.surface.unused_points, plain.unused_points);
  }
}

TEST(NoiseFilter, OutliersGoAndSamplesStay) {
  const std::vector<Point> clean = shapes::torus(80, 40, 0.4, 0.5, 3);
  const std::vector<Point> stray = scattered(60, 4, 4);
  const RobustSamples samples = robust_samples(shapes::joined(clean, stray));
  EXPECT_LE(count_left_out(samples, 0, clean.size()), clean.size() / 100);
  EXPECT_GE(count_left_out(samples, clean.size(), samples.kept.size()), 50U);
  EXPECT_GE(samples.counters.outlier_rounds, 2U);
  EXPECT_EQ(samples.distinct, clean.size() + stray.size());
}

// A sphere; the 150 samples below lie six times as far apart as those above.
std::vector<Point> half_dense_sphere() {
  std::vector<Point> points;
  for (const Point& p : gallery::even_sphere(300)) {
    if (p.z < 0) points.push_back(p);
  }
  for (const Point& p : gallery::even_sphere(12000)) {
    if (p.z >= 0) points.push_back(p);
  }
  return points;
}

// Beside the dense half the last row of the sparse one stands alone; once gone, the row behind it.
TEST(NoiseFilter, ASparseRegionBesideADenseOneStays) {
  const std::vector<Point> points = half_dense_sphere();
  const RobustSamples ours = robust_samples(points);
  EXPECT_EQ(ours.counters.outliers, 0U);
  EXPECT_EQ(ours.counters.layer_samples, 0U);
  EXPECT_EQ(ours.counters.outlier_rounds, 1U);
  EXPECT_GT(ours.counters.spared_samples, 5U);
  const RobustSamples by_spacing = robust_samples(points, {.spare_good = false});
  EXPECT_GT(by_spacing.counters.outliers, 100U);
  EXPECT_EQ(by_spacing.counters.spared_samples, 0U);
}

// What floats around such a sphere goes still; no surface surrounds it.
TEST(NoiseFilter, OutliersBesideSparedSamplesGo) {
  const std::vector<Point> clean = half_dense_sphere();
  const std::vector<Point> stray = scattered(60, 4, 4);
  const RobustSamples samples = robust_samples(shapes::joined(clean, stray));
  EXPECT_LE(count_left_out(samples, 0, clean.size()), clean.size() / 500);
  EXPECT_GE(count_left_out(samples, clean.size(), samples.kept.size()), 50U);
  EXPECT_GT(samples.counters.spared_samples, 0U);
}

struct Noisy {
  const char* name;
  std::vector<Point> points;
  std::ptrdiff_t euler;
};

// Half the spacing: too much for every reconstruction through all points.
TEST(RobustCocone, LayersOfNoiseBecomeClosedSurfacesOfTheRightKind) {
  const std::vector<Noisy> sets{
      {"sphere", shaken(shapes::sphere(2000, 5), 0.035, 6), 2},
      {"torus", shaken(shapes::torus(80, 40, 0.4, 0.3, 7), 0.032, 8), 0},
      {"two layers", shapes::joined(shapes::sphere(1500, 9), shapes::sphere(1500, 10, 1.03)), 2},
      {"outliers", shapes::joined(shapes::sphere(2000, 11), scattered(20, 3, 12)), 2}};
  for (const Noisy& set : sets) {
    const RobustResult result = reconstruct_robust(set.points);
    const MeshReport report = mesh_check(result.surface.mesh);
    EXPECT_TRUE(report.is_closed_manifold()) << set.name;
    EXPECT_EQ(report.components, 1U) << set.name;
    EXPECT_EQ(report.euler, set.euler) << set.name;
    EXPECT_GT(result.noise.outliers + result.noise.layer_samples, 0U) << set.name;
    EXPECT_EQ(result.surface.points, set.points.size());
    for (const VertexId v : result.surface.mesh.points.ids()) {
      const PointId p = result.surface.point_of_vertex[v];
      ASSERT_EQ(result.surface.mesh.points[v], set.points[p.index()]) << set.name;
    }
  }
}

// Two scans of a ball without its top, with noise of 40 % of the spacing. Through the hole infinity
// gets into the body; then both sides of the layer seem to be the outer one, and little goes.
TEST(RobustCocone, HolesOfTheDataDoNotLetTheOutsideIn) {
  const auto handles = [](const RobustResult& result) {
    const MeshReport report = mesh_check(result.surface.mesh);
    EXPECT_TRUE(report.balanced);
    return 2 * static_cast<std::ptrdiff_t>(report.components) - report.euler;
  };
  std::ptrdiff_t handles_held = 0;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const std::vector<Point> points =
        shapes::joined(shaken(shapes::cut_sphere(2500, 0.6, seed), 0.02, seed + 10),
                       shaken(shapes::cut_sphere(2500, 0.6, seed + 20), 0.02, seed + 30));
    const RobustResult held = reconstruct_robust(points);
    EXPECT_TRUE(held.noise.held);
    EXPECT_EQ(mesh_check(held.surface.mesh).components, 1U);
    EXPECT_GT(10 * held.noise.leaked_cells, 9 * held.noise.inner_cells);
    handles_held += handles(held);
    const RobustResult leaked = reconstruct_robust(points, {.max_leak = 1});
    EXPECT_FALSE(leaked.noise.held);
    EXPECT_GE(handles(leaked), 8);
    EXPECT_GT(2 * held.noise.layer_samples, 3 * leaked.noise.layer_samples);
  }
  EXPECT_LE(handles_held, 4);
}

TEST(NoiseFilter, TheSkinStaysWhereItMayBe) {
  const std::vector<Point> points = shaken(shapes::torus(60, 30, 0.4, 0.3, 5), 0.02, 6);
  const Triangulation t = delaunay(points).triangulation;
  const Dual dual = voronoi_dual(t);
  const auto spacing = sample_spacing(t, vertex_stars(t), NoiseOptions().neighbors);
  const OuterSkin plain = outer_skin(t, dual, spacing);
  IdVector<CellId, std::uint8_t> outside(t.num_cells(), 1);
  const OuterSkin everywhere = outer_skin(t, dual, spacing, {}, outside);
  EXPECT_TRUE(everywhere.balls == plain.balls);
  EXPECT_TRUE(everywhere.touched == plain.touched);
  for (const CellId c : t.finite_cells()) {
    if (dual.centers[c].x > 0) outside[c] = 0;
  }
  const OuterSkin held = outer_skin(t, dual, spacing, {}, outside);
  EXPECT_LT(held.outer_cells, plain.outer_cells);
  EXPECT_EQ(held.large_cells, plain.large_cells);
  for (const CellId c : t.finite_cells()) {
    EXPECT_FALSE(held.balls[c] == BallSize::outer && outside[c] == 0);
  }
}

TEST(RobustCocone, PublishedFilterKeepsTheSkinAlone) {
  const std::vector<Point> points = shaken(shapes::torus(80, 40, 0.4, 0.3, 5), 0.01, 6);
  const RobustSamples ours = robust_samples(points);
  const RobustSamples published = robust_samples(
      points, {.spare_good = false, .clump_share = 0, .keep_good = false, .max_leak = 1});
  EXPECT_FALSE(ours.counters.held);
  EXPECT_EQ(ours.counters.leaked_cells, 0U);
  EXPECT_GT(ours.counters.inner_cells, 0U);
  EXPECT_EQ(published.counters.inner_cells, 0U);  // nobody has looked
  EXPECT_EQ(published.counters.good_samples, 0U);
  EXPECT_GT(ours.counters.good_samples, 0U);
  EXPECT_GT(published.counters.layer_samples, ours.counters.layer_samples);
  for (const NoiseCounters& c : {ours.counters, published.counters}) {
    EXPECT_EQ(c.outliers + c.skin_samples + c.good_samples + c.layer_samples, points.size());
  }
}

// Skin, layer and outliers are those of the twin; with keep_good only samples of the layer come
// back.
TEST(RobustCocone, ChoosesAsTheTwinOnCgal) {
  const std::vector<Noisy> sets{
      {"sphere, 10 %", shaken(shapes::sphere(1500, 31), 0.008, 32), 0},
      {"sphere, 50 %", shaken(shapes::sphere(1500, 5), 0.04, 6), 0},
      {"torus", shaken(shapes::torus(60, 30, 0.4, 0.3, 7), 0.03, 8), 0},
      {"two layers", shapes::joined(shapes::sphere(1000, 9), shapes::sphere(1000, 10, 1.03)), 0},
      {"outliers", shapes::joined(shapes::sphere(1500, 11), scattered(40, 3, 12)), 0},
      {"open", shaken(shapes::cut_sphere(1500, 0.5, 13), 0.02, 14), 0},
      {"volume", shapes::random_cube(1200, 15), 0}};
  const std::vector<NoiseOptions> choices{
      {.spare_good = false, .clump_share = 0, .keep_good = false, .max_leak = 1},
      {.neighbors = 6,
       .outlier_ratio = 2,
       .spare_good = false,
       .clump_share = 0,
       .large_ratio = 2.5,
       .deep_cosine = 0.9,
       .keep_good = false,
       .max_leak = 1}};
  for (const Noisy& set : sets) {
    for (NoiseOptions noise : choices) {
      const RobustSamples skin = robust_samples(set.points, noise);
      const auto fates = ref::cgal_noise_filter(set.points, noise);
      noise.keep_good = true;
      const RobustSamples with_good = robust_samples(set.points, noise);
      std::size_t outliers = 0;
      for (const PointId p : fates.ids()) {
        outliers += fates[p] == ref::SampleFate::outlier ? 1U : 0U;
        ASSERT_EQ(skin.kept[p] != 0, fates[p] == ref::SampleFate::skin) << set.name;
        const bool may_stay = fates[p] != ref::SampleFate::outlier;
        ASSERT_TRUE(with_good.kept[p] == 0 ? skin.kept[p] == 0 : may_stay) << set.name;
      }
      EXPECT_EQ(skin.counters.outliers, outliers) << set.name;
      EXPECT_GT(skin.counters.layer_samples + outliers, 0U) << set.name;
    }
  }
}

// Spared are what the surface of all samples surrounds.
TEST(RobustCocone, SparesAsTheTwinOnCgal) {
  const std::vector<Point> points = shapes::joined(half_dense_sphere(), scattered(40, 3, 12));
  const Triangulation triangulation = delaunay(points).triangulation;
  const Dual dual = voronoi_dual(triangulation);
  const ReconstructOptions options;
  const RoughSurface surface(triangulation, dual, options);
  const IdVector<PointId, VertexId>& vertex_of_point = triangulation.vertex_of_point();
  IdVector<PointId, std::uint8_t> spared(points.size(), 0);
  for (const PointId p : spared.ids()) spared[p] = surface.good()[vertex_of_point[p]];

  const NoiseOptions noise{.clump_share = 0, .keep_good = false, .max_leak = 1};
  const RobustSamples samples = robust_samples(points, noise);
  const auto fates = ref::cgal_noise_filter(points, noise, spared);
  std::size_t outliers = 0;
  for (const PointId p : fates.ids()) {
    outliers += fates[p] == ref::SampleFate::outlier ? 1U : 0U;
    ASSERT_EQ(samples.kept[p] != 0, fates[p] == ref::SampleFate::skin);
  }
  EXPECT_EQ(samples.counters.outliers, outliers);
  EXPECT_GT(outliers, 20U);
  EXPECT_GT(samples.counters.spared_samples, 0U);
}

TEST(RobustCocone, SameChoiceForEveryOrderScaleAndThreadCount) {
  const std::vector<Point> points = shapes::joined(
      half_dense_sphere(),
      shapes::joined(shaken(shapes::sphere(1200, 13, 0.5), 0.02, 14), scattered(12, 3, 15)));
  const RobustSamples expected = robust_samples(points);
  EXPECT_GT(expected.counters.spared_samples, 0U);
  const RobustSamples threaded = robust_samples(points, {}, {}, {.threads = 3});
  EXPECT_EQ(threaded.kept, expected.kept);
  EXPECT_EQ(threaded.counters.spared_samples, expected.counters.spared_samples);
  std::vector<Point> scaled = points;
  for (Point& p : scaled) p = 0x1p+600 * p;
  EXPECT_EQ(robust_samples(scaled).kept, expected.kept);
  std::vector<Point> reversed(points.rbegin(), points.rend());
  RobustSamples other = robust_samples(reversed);
  std::reverse(other.kept.begin(), other.kept.end());
  EXPECT_EQ(other.kept, expected.kept);
  EXPECT_EQ(other.counters.spared_samples, expected.counters.spared_samples);
}

TEST(RobustCocone, RubbishIsBalancedToo) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    for (const auto& points : {shapes::random_cube(20 + 60 * seed, seed), shapes::cube_grid(3),
                               shapes::dome_patch(12, 1.0, seed)}) {
      const MeshReport report = mesh_check(reconstruct_robust(points).surface.mesh);
      EXPECT_EQ(report.unbalanced_edges, 0U) << seed;
      EXPECT_EQ(report.odd_edges, 0U) << seed;
    }
  }
}

TEST(RobustCocone, ContradictedPointsAreThoseOfTheUser) {
  Random random(1);
  std::vector<Point> points;
  for (int i = 0; i < 166; ++i) points.push_back(1.5 * random.in_unit_cube());
  points = shapes::joined(std::move(points), gallery::even_sphere(500));
  const RobustSamples samples = robust_samples(points);
  std::vector<PointId> kept;
  std::vector<Point> left;
  for (const PointId p : samples.kept.ids()) {
    if (samples.kept[p] == 0) continue;
    kept.push_back(p);
    left.push_back(points[p.index()]);
  }
  ASSERT_LT(kept.size(), points.size());
  std::vector<PointId> expected;
  for (const PointId p : reconstruct_tight(left).contradicted) expected.push_back(kept[p.index()]);
  ASSERT_FALSE(expected.empty());
  EXPECT_EQ(reconstruct_robust(points).surface.contradicted, expected);
}

TEST(RobustCocone, FarOutliersDoNotChangeWhatIsMadeOfTheRest) {
  std::vector<Point> points = shaken(gallery::even_sphere(1000), 0.04, 3);
  points.push_back({0, 3, 0});
  const RobustResult alone = reconstruct_robust(points);
  EXPECT_GT(alone.noise.outliers, 0U);
  EXPECT_GT(alone.noise.layer_samples, 0U);
  for (const double far : {1e3, 1e100, 1e150, 1e200, 1e300}) {
    std::vector<Point> more = points;
    more.push_back({far, 0, 0});
    const RobustResult result = reconstruct_robust(more);
    EXPECT_EQ(result.noise.outliers, alone.noise.outliers + 1) << far;
    EXPECT_EQ(result.noise.layer_samples, alone.noise.layer_samples) << far;
    EXPECT_EQ(result.surface.mesh, alone.surface.mesh) << far;
  }
}

// Beside points at 1e200 those of a small sphere become equal in the first triangulation, and apart
// again when the far ones have gone.
TEST(RobustCocone, PointsThatFarOutliersMergeAreCountedAsGiven) {
  std::vector<Point> points = scaled(gallery::even_sphere(1000), 4e-123);
  for (const Point& far : {Point{1e200, 0, 0}, Point{0, 1e200, 0}, Point{0, 0, 1e200},
                           Point{-1e200, -1e200, -1e200}}) {
    points.push_back(far);
  }
  points.push_back(points.front());
  const RobustResult result = reconstruct_robust(points);
  EXPECT_EQ(result.surface.duplicates, 1U);
  EXPECT_EQ(result.surface.unused_points + result.surface.mesh.points.size(), 1004U);
}

}  // namespace
}  // namespace cocoon
