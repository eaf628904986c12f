#include "update/stray_samples.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <gtest/gtest.h>
#include <map>
#include <string_view>
#include <vector>

#include "cocone/noise_filter.h"
#include "delaunay/delaunay.h"
#include "delaunay/vertex_stars.h"
#include "geom/errors.h"
#include "geom/random/random.h"
#include "tests/gallery.h"

namespace cocoon {
namespace {

// A gently curved patch, open all around: n by n samples one apart in x and `row` in y.
std::vector<Point> patch(std::size_t n, double row = 1) {
  Random random(3);
  std::vector<Point> points;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < n; ++k) {
      const double x = static_cast<double>(i) + 0.3 * random.uniform();
      const double y = row * static_cast<double>(k) + 0.3 * random.uniform();
      points.push_back({x, y, 2 * std::sin(0.2 * x) + 0.02 * random.uniform()});
    }
  }
  return points;
}

// So many around a point.
void add_clump(std::vector<Point>& points, const Point& center, std::size_t count) {
  Random random(9);
  for (std::size_t i = 0; i < count; ++i) {
    const Point p = random.in_unit_cube();
    points.push_back(center + Vec3{p.x, p.y, p.z});
  }
}

std::vector<std::uint8_t> first_kept(std::size_t kept, std::size_t all) {
  std::vector<std::uint8_t> flags(all, 0);
  std::fill_n(flags.begin(), kept, std::uint8_t{1});
  return flags;
}

TEST(StraySamples, NothingOfACleanPatchGoes) {
  for (const double row : {1.0, 3.0}) {
    const std::vector<Point> cloud = patch(20, row);
    const StraySamples strays = stray_samples(cloud);
    EXPECT_EQ(strays.kept.raw(), first_kept(cloud.size(), cloud.size())) << row;
    EXPECT_EQ(strays.outliers + strays.small_parts, 0U);
  }
}

TEST(StraySamples, SingleOnesAndClumpsGo) {
  std::vector<Point> cloud = patch(20);
  const std::size_t good = cloud.size();
  for (const Point& p : {Point{5, 5, 4.5}, Point{12, 9, -2}, Point{23, 10, -4}}) cloud.push_back(p);
  add_clump(cloud, {10, 10, 12}, 7);
  add_clump(cloud, {3, 16, -12}, 11);
  cloud.push_back(cloud[good]);  // an equal one shares its fate
  const StraySamples strays = stray_samples(cloud);
  EXPECT_EQ(strays.kept.raw(), first_kept(good, cloud.size()));
  EXPECT_EQ(strays.outliers + strays.in_small_parts, 21U);  // different ones
  EXPECT_GE(strays.small_parts, 2U);
}

TEST(StraySamples, ASecondPatchIsNoClump) {
  std::vector<Point> cloud = patch(20);
  for (const Point& p : patch(4)) cloud.push_back(p + Vec3{0, 0, 15});
  EXPECT_EQ(stray_samples(cloud).small_parts, 0U);
  EXPECT_EQ(stray_samples(cloud, {.min_part = 17}).small_parts, 1U);
  EXPECT_EQ(stray_samples(cloud, {.min_part = 0}).small_parts, 0U);
}

TEST(StraySamples, TheLargestPartStays) {
  const std::vector<Point> cloud = patch(3);
  EXPECT_EQ(stray_samples(cloud).kept.raw(), first_kept(9, 9));
}

TEST(StraySamples, NeitherOrderNorThreadsMatter) {
  std::vector<Point> cloud = patch(20);
  cloud.push_back({5, 5, 8});
  add_clump(cloud, {10, 10, 12}, 7);
  const StraySamples strays = stray_samples(cloud);
  std::vector<Point> reversed(cloud.rbegin(), cloud.rend());
  const StraySamples again = stray_samples(reversed, {}, {}, {4});
  EXPECT_TRUE(std::equal(strays.kept.begin(), strays.kept.end(), again.kept.raw().rbegin()));
}

// Decisions are ratios: they hold at any scale.
TEST(StraySamples, OfAnySize) {
  std::vector<Point> cloud = patch(12);
  cloud.push_back({5, 5, 8});
  for (Point& p : cloud) p = 1e-180 * p;
  EXPECT_EQ(stray_samples(cloud).kept.raw(), first_kept(cloud.size() - 1, cloud.size()));
}

// Without outliers, what does not stay are parts, found by spreading until nothing changes.
void compare_parts_with_definition(const std::vector<Point>& cloud, StrayOptions options) {
  options.outlier_ratio = 1e9;
  const StraySamples strays = stray_samples(cloud, options);
  const Triangulation t = delaunay(cloud).triangulation;
  const VertexStars stars = vertex_stars(t);
  const IdVector<VertexId, double> spacing = sample_spacing(t, stars, options.neighbors);
  IdVector<VertexId, std::uint32_t> part(t.num_vertices());
  for (const VertexId v : t.vertices()) part[v] = v.value;
  for (bool changed = true; changed;) {
    changed = false;
    for (const CellId c : t.finite_cells()) {
      for (const VertexId v : t.cell(c).vertices) {
        for (const VertexId w : t.cell(c).vertices) {
          const double reach = options.link_ratio * std::min(spacing[v], spacing[w]);
          if (part[w] >= part[v] || distance(t.point(v), t.point(w)) > reach) continue;
          part[v] = part[w];
          changed = true;
        }
      }
    }
  }
  std::map<std::uint32_t, std::size_t> size;
  std::size_t largest = 0;
  for (const VertexId v : t.vertices()) largest = std::max(largest, ++size[part[v]]);
  const auto is_small = [&](std::size_t n) { return n < largest && n < options.min_part; };
  std::size_t small_parts = 0;
  std::size_t in_small_parts = 0;
  for (const auto& [first, n] : size) {
    small_parts += is_small(n) ? 1U : 0U;
    in_small_parts += is_small(n) ? n : 0U;
  }
  EXPECT_EQ(strays.outliers, 0U);
  EXPECT_EQ(strays.small_parts, small_parts);
  EXPECT_EQ(strays.in_small_parts, in_small_parts);
  for (const VertexId v : t.vertices()) {
    const auto at = std::find(cloud.begin(), cloud.end(), t.point(v)) - cloud.begin();
    EXPECT_EQ(strays.kept[PointId(static_cast<std::size_t>(at))] != 0, !is_small(size[part[v]]));
  }
}

TEST(StraySamples, SmallPartsAreThoseOfTheirDefinition) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    Random random(seed);
    std::vector<Point> cloud;
    while (cloud.size() < 200) {  // ever sparser from one end to the other
      const Point p = random.in_unit_cube();
      cloud.push_back({std::exp(3 * p.x), p.y, 0.2 * p.z});
    }
    for (const double link_ratio : {0.8, 1.0, 1.3, 2.0, 3.0}) {
      for (const std::size_t neighbors : {1U, 3U, 8U}) {
        compare_parts_with_definition(
            cloud, {.neighbors = neighbors, .link_ratio = link_ratio, .min_part = 12});
      }
    }
  }
  // Samples as far apart as they may be hang together.
  const std::vector<Point> grid = gallery::integer_grid(4);
  EXPECT_EQ(stray_samples(grid, {.link_ratio = 1}).small_parts, 0U);
  compare_parts_with_definition(grid, {.link_ratio = 1});
}

// What hangs together with the patch by an outlier goes with it.
TEST(StraySamples, AClumpBehindAnOutlierGoes) {
  std::vector<Point> cloud = patch(20);
  const std::size_t good = cloud.size();
  cloud.push_back({10, 10, 5.4});
  add_clump(cloud, {9.5, 9.5, 8}, 7);
  const StraySamples strays = stray_samples(cloud, {.link_ratio = 5});
  EXPECT_EQ(strays.kept.raw(), first_kept(good, cloud.size()));
  EXPECT_EQ(strays.outliers, 1U);
  EXPECT_EQ(strays.small_parts, 1U);
  EXPECT_EQ(strays.in_small_parts, 7U);
  EXPECT_EQ(stray_samples(cloud, {.outlier_ratio = 1e9, .link_ratio = 5}).small_parts, 0U);
}

TEST(StraySamples, ProgressIsOfNoise) {
  struct Stages : Progress {
    bool report(std::string_view stage, double) override {
      all_of_noise = all_of_noise && stage.starts_with("noise");
      ++reports;
      return true;
    }
    bool all_of_noise = true;
    int reports = 0;
  } stages;
  stray_samples(patch(20), {}, {}, {.progress = &stages});
  EXPECT_GT(stages.reports, 0);
  EXPECT_TRUE(stages.all_of_noise);
}

// As that of a face from which a boss was taken off.
TEST(StraySamples, AFlatPatchStaysAndLosesItsStrays) {
  std::vector<Point> cloud;
  Random random(4);
  for (int i = 0; i < 20; ++i) {
    for (int k = 0; k < 20; ++k) {
      cloud.push_back({i + 0.3 * random.uniform(), k + 0.3 * random.uniform(), 7});
    }
  }
  const std::size_t good = cloud.size();
  EXPECT_EQ(stray_samples(cloud).kept.raw(), first_kept(good, good));

  // Without the first two the rest is flat, and has an outlier itself.
  cloud.push_back({5, 5, 30});
  cloud.push_back({12, 3, -20});
  cloud.push_back({40, 40, 7});
  const StraySamples strays = stray_samples(cloud);
  EXPECT_EQ(strays.kept.raw(), first_kept(good, cloud.size()));
  EXPECT_EQ(strays.outliers + strays.in_small_parts, 3U);

  // Outliers alone, in rounds: the one in the plane comes after the others.
  const StraySamples outliers = stray_samples(cloud, {.min_part = 0});
  EXPECT_EQ(outliers.kept.raw(), first_kept(good, cloud.size()));
  EXPECT_EQ(outliers.outliers, 3U);
}

TEST(StraySamples, TooFewPointsAreAnError) {
  const std::vector<Point> few = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  EXPECT_THROW(stray_samples(few), InputError);
  const std::vector<Point> on_a_line = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {5, 0, 0}};
  EXPECT_THROW(stray_samples(on_a_line), InputError);
}

}  // namespace
}  // namespace cocoon
