#include "update/checks/crowded_samples.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <vector>

#include "geom/errors.h"
#include "tests/update/hand_made_models.h"

namespace cocoon {
namespace {

// The middle of a plane with edges of length 1 and the root of 2 goes; samples come on a grid of
// this spacing, in so many layers.
struct ScannedMiddle {
  TriangleMesh model = testing::grid_plane(10);
  std::vector<VertexId> removed;
  std::vector<std::vector<Point>> clouds;

  ScannedMiddle(double spacing, int layers) {
    for (const VertexId v : model.points.ids()) {
      if (distance(model.points[v], {5, 5, 0}) < 3) removed.push_back(v);
    }
    for (int layer = 0; layer < layers; ++layer) {
      std::vector<Point>& cloud = clouds.emplace_back();
      for (double x = 2; x < 8; x += spacing) {
        for (double y = 2; y < 8; y += spacing) cloud.push_back({x, y, 0.1 * layer});
      }
    }
  }
  // All of them joined.
  CrowdedSamples found(const CrowdedOptions& options = {}) const {
    std::vector<JoinedCloud> joined(1);
    for (std::size_t c = 0; c < clouds.size(); ++c) joined[0].members.push_back(c);
    return crowded_samples(ModelIndex(model), removed, joined, clouds, options);
  }
};

TEST(CrowdedSamples, AreThoseOfLayersOrOfAFinerScan) {
  const CrowdedSamples single = ScannedMiddle(1, 1).found();
  EXPECT_EQ(single.distance, 0.62);  // two of three edges at a vertex have length 1
  EXPECT_EQ(single.closer, 0U);
  const CrowdedSamples layers = ScannedMiddle(1, 3).found();
  EXPECT_EQ(layers.of, 108U);
  EXPECT_EQ(layers.closer, 72U);
  EXPECT_EQ(layers.thickness, 0);  // three samples tell nothing
  EXPECT_EQ(ScannedMiddle(1, 3).found({.min_share = 0.7}).closer, 0U);
  EXPECT_EQ(ScannedMiddle(0.5, 1).found().closer, 72U);  // every other one of 144
  EXPECT_EQ(ScannedMiddle(0.5, 1).found().in_layers, 0U);
  EXPECT_EQ(ScannedMiddle(0.5, 1).found({.distance = 0.4}).closer, 0U);
}

TEST(CrowdedSamples, InLayersAreFlagged) {
  const CrowdedSamples found = ScannedMiddle(0.4, 3).found();
  EXPECT_GT(found.thickness, 0.2);
  EXPECT_EQ(found.in_layers, found.closer);
  ASSERT_EQ(found.is_in_layers.size(), 3U);
  std::size_t flagged = 0;
  for (const SampleFlags& flags : found.is_in_layers) {
    flagged += static_cast<std::size_t>(std::count(flags.begin(), flags.end(), 1));
  }
  EXPECT_EQ(flagged, found.in_layers);
  EXPECT_EQ(found.is_in_layers[0][PointId(0)], 0);  // lexicographically before those above it
  EXPECT_EQ(found.is_in_layers[2][PointId(0)], 1);
  EXPECT_EQ(ScannedMiddle(0.4, 3).found({.min_thickness = 0.5}).in_layers, 0U);
}

// Two walls, half as far apart as the edges of the model are long, are no layers where samples lie
// closer together than the walls; and the edges of a CAD mesh tell nothing.
TEST(CrowdedSamples, WallsAreNoLayers) {
  const auto of_walls = [](double spacing, const CrowdedOptions& options) {
    ScannedMiddle scene(spacing, 1);
    const std::size_t size = scene.clouds[0].size();
    for (std::size_t k = 0; k < size; ++k) {
      const Point p = scene.clouds[0][k];
      scene.clouds[0].push_back({p.x, p.y, 0.5});
    }
    return scene.found(options);
  };
  const CrowdedSamples found = of_walls(0.2, {});
  EXPECT_GT(found.closer, 100U);
  EXPECT_EQ(found.thickness, 0);
  EXPECT_EQ(found.depth, 0);
  EXPECT_EQ(found.in_layers, 0U);
  EXPECT_GT(of_walls(0.45, {}).in_layers, 0U);  // those are as close as samples
  EXPECT_EQ(of_walls(0.2, {.max_coarseness = 1}).closer, 0U);
  EXPECT_EQ(of_walls(0.05, {}).closer, 0U);
}

// A finer scan elsewhere is no layer because of layers here.
TEST(CrowdedSamples, OfEachCloudAreJudgedByThemselves) {
  ScannedMiddle scene(0.4, 3);
  const std::size_t in_layers = scene.found().in_layers;
  scene.clouds.push_back({});
  for (double x = 20; x < 26; x += 0.3) {
    for (double y = 2; y < 8; y += 0.3) scene.clouds.back().push_back({x, y, 0});
  }
  const std::vector<JoinedCloud> joined = {{.members = {0, 1, 2}, .sheet = {}},
                                           {.members = {3}, .sheet = {}}};
  const CrowdedSamples found =
      crowded_samples(ModelIndex(scene.model), scene.removed, joined, scene.clouds);
  EXPECT_GT(found.closer, in_layers);
  EXPECT_EQ(found.in_layers, in_layers);
  const SampleFlags& fine = found.is_in_layers[3];
  EXPECT_EQ(fine.size(), scene.clouds[3].size());
  EXPECT_EQ(std::count(fine.begin(), fine.end(), 1), 0);
}

TEST(CrowdedSamples, GivenTwiceCrowdNobody) {
  ScannedMiddle scene(0.4, 3);
  const CrowdedSamples expected = scene.found();
  scene.clouds.push_back(scene.clouds[0]);
  const CrowdedSamples found = scene.found();
  EXPECT_EQ(found.closer, expected.closer);
  EXPECT_EQ(found.of, expected.of);
  EXPECT_EQ(found.thickness, expected.thickness);
  EXPECT_EQ(found.is_in_layers[1], expected.is_in_layers[1]);
  EXPECT_EQ(found.is_in_layers[3], found.is_in_layers[0]);
  ScannedMiddle single(1, 1);
  single.clouds.push_back(single.clouds[0]);
  EXPECT_EQ(single.found().closer, 0U);
}

// As join_clouds() returns it if no two overlap.
TEST(CrowdedSamples, WithoutJoinedCloudsEachIsByItself) {
  ScannedMiddle scene(0.4, 1);
  std::vector<Point> second = scene.clouds[0];
  for (Point& p : second) p.z = 0.1;
  scene.clouds[0].insert(scene.clouds[0].end(), second.begin(), second.end());
  const CrowdedSamples found =
      crowded_samples(ModelIndex(scene.model), scene.removed, {}, scene.clouds);
  EXPECT_GT(found.in_layers, 0U);
  EXPECT_EQ(found.in_layers, scene.found().in_layers);
  const std::vector<JoinedCloud> wrong = {{.members = {1}, .sheet = {}}};
  EXPECT_THROW(crowded_samples(ModelIndex(scene.model), scene.removed, wrong, scene.clouds),
               InputError);
}

TEST(CrowdedSamples, WithoutVerticesThatWentThereAreNone) {
  ScannedMiddle scene(1, 3);
  scene.removed.clear();
  EXPECT_EQ(scene.found().closer, 0U);
  EXPECT_EQ(scene.found().distance, 0);
  scene.removed = {VertexId(scene.model.points.size())};
  EXPECT_THROW(scene.found(), InputError);
}

}  // namespace
}  // namespace cocoon
