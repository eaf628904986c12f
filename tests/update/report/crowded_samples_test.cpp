#include "update/report/crowded_samples.h"

#include <cmath>
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
  CrowdedSamples found(const CrowdedOptions& options = {}) const {
    return crowded_samples(ModelIndex(model), removed, clouds, options);
  }
};

TEST(CrowdedSamples, AreThoseOfLayersOrOfAFinerScan) {
  const CrowdedSamples single = ScannedMiddle(1, 1).found();
  EXPECT_EQ(single.distance, 0.62);  // two of three edges at a vertex have length 1
  EXPECT_EQ(single.of, 36U);
  EXPECT_EQ(single.closer, 0U);
  EXPECT_FALSE(single.are_many({}));
  const CrowdedSamples layers = ScannedMiddle(1, 3).found();
  EXPECT_EQ(layers.of, 108U);
  EXPECT_EQ(layers.closer, 72U);
  EXPECT_TRUE(layers.are_many({}));
  EXPECT_FALSE(layers.are_many({.min_share = 0.7}));
  EXPECT_EQ(layers.thickness, 0);  // three samples tell nothing
  EXPECT_TRUE(ScannedMiddle(0.4, 3).found().are_in_layers({}));
  EXPECT_FALSE(ScannedMiddle(0.4, 3).found().are_in_layers({.min_thickness = 0.3}));
  EXPECT_EQ(layers.is_closer.size(), 3U);
  for (const PointId p : layers.is_closer[0].ids()) {
    EXPECT_EQ(layers.is_closer[0][p], 0);  // lexicographically before those above it
    EXPECT_EQ(layers.is_closer[2][p], 1);
  }
  EXPECT_EQ(ScannedMiddle(0.5, 1).found().closer, 72U);  // every other one of 144
  EXPECT_TRUE(ScannedMiddle(0.5, 1).found().are_many({}));
  EXPECT_FALSE(ScannedMiddle(0.5, 1).found().are_in_layers({}));
  EXPECT_EQ(ScannedMiddle(0.5, 1).found({.distance = 0.4}).closer, 0U);
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
