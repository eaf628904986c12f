#include "update/contradicted_islands.h"

#include <gtest/gtest.h>
#include <vector>

#include "tests/update/hand_made_models.h"

namespace cocoon {
namespace {

// A block with a square ring of border on its top, and a scan that lies on the top outside the
// ring and at another height inside. What is inside the ring is an island.
struct RingOnABlock {
  TriangleMesh block = testing::block(20, 20, 6);
  ModelIndex model{block};
  Regions regions;
  RegionChoice choice;
  std::vector<Point> samples;

  explicit RingOnABlock(double height) {
    TriangleSet border(block.triangles.size(), 0);
    for (const TriangleId t : block.triangles.ids()) {
      const Point middle = model.centroid(t);
      border[t] = middle.z == 6 && in_ring(middle) ? 1 : 0;
    }
    regions = segment_model(model, border);
    choice.replaced = IdVector<RegionId, std::uint8_t>(regions.regions.size(), 0);
    choice.clouds.resize(1);
    for (const RegionId r : regions.regions.ids()) {
      choice.clouds[0].regions.push_back({.region = r, .edges = 10});
    }
    for (double x = 2.3; x < 18; ++x) {
      for (double y = 2.3; y < 18; ++y) {
        const bool inside = 7 < x && x < 13 && 7 < y && y < 13;
        samples.push_back({x, y, inside ? height : 6.1});
      }
    }
  }
  static bool in_ring(const Point& p) {
    const auto within = [&](double least) {
      return least < p.x && p.x < 20 - least && least < p.y && p.y < 20 - least;
    };
    return within(5) && !within(6);
  }
  RegionId island() const {
    return regions.group_of_vertex[testing::nearest_vertex(block, {10, 10, 6})];
  }
  // The regions that go.
  std::vector<RegionId> found(const IslandOptions& options = {}) {
    const Scan scan{samples, 1};
    std::vector<RegionId> parts;
    for (const ContradictedIsland& island :
         part_contradicted_islands(model, choice, {&scan, 1}, regions, options)) {
      parts.push_back(island.part);
    }
    return parts;
  }
};

// Deeper than the middle of the block, where its other side is closer.
TEST(ContradictedIslands, OverAFloor) {
  for (const double floor : {4.0, 2.0}) {
    RingOnABlock scene(floor);
    ASSERT_EQ(scene.regions.regions.size(), 2U);
    EXPECT_EQ(scene.found(), std::vector{scene.island()}) << floor;
  }
}

TEST(ContradictedIslands, UnderTheTopOfABoss) {
  RingOnABlock scene(11);
  EXPECT_EQ(scene.found(), std::vector{scene.island()});
}

TEST(ContradictedIslands, NotWhereTheScanEnds) {
  RingOnABlock scene(4);
  std::erase_if(scene.samples, [](const Point& p) { return p.z < 5; });
  EXPECT_TRUE(scene.found().empty());
}

// The top of a boss over one side of it, the other side in its shadow.
TEST(ContradictedIslands, StayWhereNothingLiesOverThem) {
  RingOnABlock scene(11);
  std::erase_if(scene.samples, [](const Point& p) { return p.z > 7 && p.x > 9; });
  const RegionId island = scene.island();
  const std::size_t facets = scene.regions.regions[island].facets;
  const std::vector<RegionId> parts = scene.found({.min_share = 0.05, .reach = 1.5});
  ASSERT_EQ(parts, std::vector{RegionId(2)});
  const auto& regions = scene.regions.regions;
  ASSERT_EQ(regions.size(), 3U);
  EXPECT_EQ(regions[island].facets + regions[parts[0]].facets, facets);
  EXPECT_EQ(scene.island(), RegionId());  // on the line between them
  const auto group_at = [&](double x) {
    return scene.regions.group_of_vertex[testing::nearest_vertex(scene.block, {x, 10, 6})];
  };
  EXPECT_EQ(group_at(8), parts[0]);
  EXPECT_EQ(group_at(12), island);
}

TEST(ContradictedIslands, NotOfFewSamples) {
  RingOnABlock scene(4);
  EXPECT_FALSE(scene.found({.min_samples = 36}).empty());
  EXPECT_TRUE(scene.found({.min_samples = 37}).empty());
  // 36 of them, 128 facets.
  EXPECT_FALSE(scene.found({.min_share = 0.28}).empty());
  EXPECT_TRUE(scene.found({.min_share = 0.29}).empty());
  EXPECT_TRUE(scene.found({.off_model = 2.5}).empty());
}

TEST(ContradictedIslands, NotThoseThatNoRimSeesNorThoseThatGo) {
  RingOnABlock scene(4);
  for (RegionVerdict& verdict : scene.choice.clouds[0].regions) verdict.edges = 0;
  EXPECT_TRUE(scene.found().empty());
  RingOnABlock other(4);
  other.choice.replaced[other.island()] = 1;
  EXPECT_TRUE(other.found().empty());
}

}  // namespace
}  // namespace cocoon
