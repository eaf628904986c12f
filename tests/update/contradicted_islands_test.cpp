#include "update/contradicted_islands.h"

#include <cstddef>
#include <gtest/gtest.h>
#include <utility>
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
  std::vector<RegionId> found(const IslandOptions& options = {}, double spacing = 1) {
    const Scan scan{samples, spacing};
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

// The samples inside the ring, and others there at a second height, with the ways they face.
struct TwoSheetsOverTheRing : RingOnABlock {
  std::vector<Outward> normals;

  TwoSheetsOverTheRing(double height, double up, double second, double second_up)
      : RingOnABlock(height), normals(samples.size(), Outward{{0, 0, up}}) {
    const std::vector<Point> first = samples;
    for (const Point& p : first) {
      if (p.z != height) continue;
      samples.push_back({p.x, p.y, second});
      normals.push_back({{0, 0, second_up}});
    }
  }
  bool is_island_found(const IslandOptions& options = {}) {
    const Scan scan{samples, 1};
    return !part_contradicted_islands(model, choice, {&scan, 1}, regions, options,
                                      [&](std::size_t) { return normals; })
                .empty();
  }
};

// Under an arch there is room between, and the region may well be as it was.
TEST(ContradictedIslands, NotUnderWhatFacesThem) {
  EXPECT_FALSE(TwoSheetsOverTheRing(11, 1, 9, -1).is_island_found());
  EXPECT_FALSE(TwoSheetsOverTheRing(9, -1, 11, 0).is_island_found());
  EXPECT_TRUE(TwoSheetsOverTheRing(11, 1, 9, -1).is_island_found({.facing_reach = 0}));
  EXPECT_TRUE(TwoSheetsOverTheRing(11, 1, 9, 0).is_island_found());     // nothing is known of it
  EXPECT_TRUE(TwoSheetsOverTheRing(11, 1, 9, -0.4).is_island_found());  // a slanted wall
  // A boss with something over it.
  EXPECT_TRUE(TwoSheetsOverTheRing(9, 1, 11, -1).is_island_found());
  // The floor of a pocket, and the other side of the body, deeper.
  EXPECT_TRUE(TwoSheetsOverTheRing(4, 1, 2, -1).is_island_found());
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
  scene.samples.push_back({3, 3, 12});  // off the model, too, but not over the island
  EXPECT_TRUE(scene.found({.min_samples = 37}).empty());
  // 36 of them, 128 facets.
  EXPECT_FALSE(scene.found({.min_share = 0.28}).empty());
  EXPECT_TRUE(scene.found({.min_share = 36 / 128.0}).empty());  // not more
  EXPECT_TRUE(scene.found({.min_share = 0.29}).empty());
  EXPECT_TRUE(scene.found({.off_model = 2.5}).empty());
}

// Half as dense, the scan lies within 1.2 spacings of the model; twice as dense, three are 1.5.
TEST(ContradictedIslands, AreMeasuredInSpacings) {
  EXPECT_TRUE(RingOnABlock(4).found({}, 2).empty());
  std::vector<std::size_t> facets;
  for (const double spacing : {1.0, 0.5}) {
    RingOnABlock scene(11);
    std::erase_if(scene.samples, [](const Point& p) { return p.z > 7 && p.x > 9; });
    const IslandOptions options{.min_share = 0.05, .reach = 1.5 / spacing};
    ASSERT_EQ(scene.found(options, spacing), std::vector{RegionId(2)});
    facets.push_back(scene.regions.regions[RegionId(2)].facets);
  }
  EXPECT_EQ(facets[0], facets[1]);
}

// A floor of the model lies between the island and the samples, too far below them to be theirs.
TEST(ContradictedIslands, NotWhereAnotherRegionIsNearer) {
  RingOnABlock scene(4);
  TriangleMesh model = scene.block;
  const auto shift = static_cast<std::uint32_t>(model.points.size());
  const TriangleMesh floor = testing::grid_plane(10);
  for (const Point& p : floor.points) model.points.push_back(p + Vec3{5, 5, 2.5});
  for (Triangle t : floor.triangles) {
    for (VertexId& v : t) v = VertexId(v.value + shift);
    model.triangles.push_back(t);
    scene.regions.region_of_facet.push_back(RegionId(2U));
  }
  scene.regions.regions.push_back({});
  scene.choice.replaced.push_back(0);
  const ModelIndex index(model);
  const Scan scan{scene.samples, 1};
  EXPECT_TRUE(part_contradicted_islands(index, scene.choice, {&scan, 1}, scene.regions).empty());
}

TEST(ContradictedIslands, OfTwoScansGoOnce) {
  RingOnABlock scene(4);
  scene.choice.clouds.push_back(scene.choice.clouds[0]);
  const Scan scans[] = {{scene.samples, 1}, {scene.samples, 1}};
  EXPECT_EQ(part_contradicted_islands(scene.model, scene.choice, scans, scene.regions).size(), 1U);
}

// One lies over one end of the island, one over the other: what goes is near either, whichever
// comes first.
TEST(ContradictedIslands, OfTwoScansAtTwoEndsBothGo) {
  const auto facets_that_go = [](double first, double second) {
    RingOnABlock scene(4);
    scene.choice.clouds.push_back(scene.choice.clouds[0]);
    const auto at_end = [&](double side) {
      std::vector<Point> samples;
      for (const Point& p : scene.samples) {
        if (p.z > 5 || side * (p.x - 10) > 1) samples.push_back(p);
      }
      return samples;
    };
    const std::vector<Point> clouds[] = {at_end(first), at_end(second)};
    const Scan scans[] = {{clouds[0], 0.5}, {clouds[1], 0.5}};
    const auto found = part_contradicted_islands(scene.model, scene.choice, scans, scene.regions,
                                                 {.min_share = 0.05, .reach = 2});
    EXPECT_EQ(found.size(), 1U);
    std::size_t west = 0;
    std::size_t east = 0;
    for (const TriangleId t : scene.block.triangles.ids()) {
      if (scene.regions.region_of_facet[t] != found.front().part) continue;
      ++(scene.model.centroid(t).x < 10 ? west : east);
    }
    return std::pair(west, east);
  };
  const auto [west, east] = facets_that_go(-1, 1);
  EXPECT_GT(west, 0U);
  EXPECT_GT(east, 0U);
  EXPECT_EQ(facets_that_go(1, -1), std::pair(west, east));
}

// The second cloud did not see the region.
TEST(ContradictedIslands, WhoSawTheRegionSawThePartThatGoes) {
  RegionChoice choice;
  choice.replaced = IdVector<RegionId, std::uint8_t>(3, 0);
  choice.clouds.resize(2);
  choice.clouds[0].regions = {{.region = RegionId(1U), .mean_angle = 2, .edges = 7}};
  choose_island({RegionId(1U), RegionId(2U)}, choice);
  EXPECT_EQ(choice.replaced[RegionId(1U)], 0);
  EXPECT_EQ(choice.replaced[RegionId(2U)], 1);
  ASSERT_EQ(choice.clouds[0].regions.size(), 2U);
  EXPECT_FALSE(choice.clouds[0].regions[0].under_cloud);
  EXPECT_EQ(choice.clouds[0].regions[1].region, RegionId(2U));
  EXPECT_EQ(choice.clouds[0].regions[1].edges, 7U);
  EXPECT_TRUE(choice.clouds[0].regions[1].under_cloud);
  EXPECT_TRUE(choice.clouds[1].regions.empty());
  choose_island({RegionId(1U), RegionId(1U)}, choice);  // all of it
  ASSERT_EQ(choice.clouds[0].regions.size(), 2U);
  EXPECT_TRUE(choice.clouds[0].regions[0].under_cloud);
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
