#include "update/stray_samples.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "geom/errors.h"
#include "geom/random.h"

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

// Samples in a row from the patch to the clump: each is an outlier, without which the clump hangs
// together with nothing.
TEST(StraySamples, AClumpAtTheEndOfAnOutlierGoes) {
  std::vector<Point> cloud = patch(20);
  const std::size_t good = cloud.size();
  cloud.push_back({10, 10, 5.2});
  add_clump(cloud, {9.5, 9.5, 7.5}, 7);
  const StraySamples strays = stray_samples(cloud);
  EXPECT_EQ(strays.kept.raw(), first_kept(good, cloud.size()));
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

TEST(StraySamples, TooFewPointsAreAnError) {
  const std::vector<Point> flat = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}};
  EXPECT_THROW(stray_samples(flat), InputError);
}

}  // namespace
}  // namespace cocoon
