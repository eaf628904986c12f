#include "update/scan_ends.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <vector>

#include "tests/update/hand_made_models.h"
#include "update/model/triangle_set.h"

namespace cocoon {
namespace {

const Point middle = {15.1, 15.2, 0};
constexpr double radius = 6;

// A disk of samples a unit apart.
std::vector<Point> disk() {
  std::vector<Point> samples;
  for (double x = 0.3; x < 30; ++x) {
    for (double y = 0.4; y < 30; ++y) {
      if (distance(Point{x, y, 0}, middle) <= radius) samples.push_back({x, y, 0});
    }
  }
  return samples;
}

// Rings of samples on a cylinder that stands on the rim of the disk.
void add_wall(std::vector<Point>& samples, double height) {
  for (double z = 0; z <= height; z += 0.8) {
    for (int k = 0; k < 40; ++k) {
      const double angle = 2 * std::numbers::pi * k / 40;
      samples.push_back(middle + Vec3{radius * std::cos(angle), radius * std::sin(angle), z});
    }
  }
}

struct Plane {
  TriangleMesh mesh = testing::grid_plane(30);
  ModelIndex model{mesh};
  TriangleSet all = TriangleSet(mesh.triangles.size(), 1);

  std::vector<TriangleId> ends(const std::vector<Point>& samples, const Vec3& shift = {}) const {
    const std::vector<Scan> scans = {{samples, 1, shift}};
    return scan_ends(model, members(all), scans);
  }
};

// Two spacings beyond the disk, all around it.
TEST(ScanEnds, AreARingBeyondTheLastSamples) {
  const Plane plane;
  const std::vector<TriangleId> ends = plane.ends(disk());
  EXPECT_GT(ends.size(), 40U);
  std::vector<int> sectors(12, 0);
  for (const TriangleId t : ends) {
    const Vec3 from_middle = plane.model.centroid(t) - middle;
    EXPECT_GT(norm(from_middle), radius + 0.8);
    EXPECT_LT(norm(from_middle), radius + 3);
    const double turns = std::atan2(from_middle.y, from_middle.x) / (2 * std::numbers::pi);
    ++sectors[static_cast<std::size_t>(std::floor(12 * (turns + 1))) % 12];
  }
  for (const int found : sectors) EXPECT_GT(found, 0);
}

TEST(ScanEnds, AreNotWhereTheScannedSurfaceLeavesTheModel) {
  const Plane plane;
  std::vector<Point> samples = disk();
  add_wall(samples, 5);
  EXPECT_TRUE(plane.ends(samples).empty());
  // As high as noise.
  samples = disk();
  add_wall(samples, 0.4);
  EXPECT_FALSE(plane.ends(samples).empty());
}

// A scan out of register lies on the model as much as it would in its place.
TEST(ScanEnds, AreFoundOfAScanOutOfRegister) {
  const Plane plane;
  std::vector<Point> samples = disk();
  for (Point& p : samples) p.z = 0.6;
  EXPECT_TRUE(plane.ends(samples).empty());
  EXPECT_GT(plane.ends(samples, {0, 0, 0.6}).size(), 40U);
  // What is thought of it may be wrong: samples that lie on the model do so.
  EXPECT_EQ(plane.ends(disk(), {0, 0, 0.6}), plane.ends(disk()));
}

TEST(ScanEnds, AreLookedForAmongTheGivenFacets) {
  Plane plane;
  const std::vector<TriangleId> everywhere = plane.ends(disk());
  std::vector<TriangleId> expected;
  for (const TriangleId t : plane.mesh.triangles.ids()) {
    plane.all[t] = plane.model.centroid(t).x < middle.x ? 1 : 0;
  }
  for (const TriangleId t : everywhere) {
    if (plane.all[t] != 0) expected.push_back(t);
  }
  EXPECT_EQ(plane.ends(disk()), expected);
  EXPECT_LT(expected.size(), everywhere.size());
  EXPECT_TRUE(scan_ends(plane.model, members(plane.all), {}).empty());
}

// Of two scans that meet, nothing ends where one goes on beyond the other.
TEST(ScanEnds, AreThoseOfAllScansTogether) {
  const Plane plane;
  std::vector<Point> left;
  std::vector<Point> right;
  for (const Point& p : disk()) (p.x < middle.x ? left : right).push_back(p);
  const std::vector<Scan> scans = {{left, 1}, {right, 1}};
  EXPECT_EQ(scan_ends(plane.model, members(plane.all), scans), plane.ends(disk()));
  EXPECT_NE(plane.ends(left), plane.ends(disk()));
}

// A region that reaches far beyond the samples, and in which they end, is not all under them.
TEST(ScanEnds, TellThatARegionIsNotAllUnderTheScan) {
  const Plane plane;
  Regions regions;
  regions.regions.resize(2);
  regions.region_of_facet = SparseVector<TriangleId, RegionId>(plane.mesh.triangles.size());
  const auto set = [&](double limit) {
    for (const TriangleId t : plane.mesh.triangles.ids()) {
      const bool outside = distance(plane.model.centroid(t), middle) > limit;
      regions.region_of_facet.set(t, RegionId(outside ? 1U : 0U));
    }
  };
  CloudChoice choice;
  choice.regions = {{RegionId(0U), 0.1, 10, true}, {RegionId(1U), 3, 10, false}};
  const std::vector<Point> samples = disk();
  const Scan scan = {samples, 1};
  set(radius);
  EXPECT_FALSE(scan_ends_under(plane.model, regions, choice, scan));
  set(2 * radius);
  EXPECT_TRUE(scan_ends_under(plane.model, regions, choice, scan));
  choice.regions[0].under_cloud = false;
  EXPECT_FALSE(scan_ends_under(plane.model, regions, choice, scan));
}

}  // namespace
}  // namespace cocoon
