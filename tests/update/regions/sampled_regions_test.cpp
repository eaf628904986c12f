#include "update/regions/sampled_regions.h"

#include <cstdint>
#include <gtest/gtest.h>
#include <vector>

#include "geom/errors.h"
#include "tests/update/hand_made_models.h"

namespace cocoon {
namespace {

using Flags = std::vector<std::uint8_t>;

// A plane with a border around the square from 7 to 13: inside is region 1, outside region 0.
struct SquareOnAPlane {
  TriangleMesh plane = testing::grid_plane(20);
  ModelIndex model{plane};
  Regions regions;

  SquareOnAPlane() {
    TriangleSet border(plane.triangles.size(), 0);
    for (const TriangleId t : plane.triangles.ids()) {
      const Point c = centroid(t);
      const bool is_inside = 7 < c.x && c.x < 13 && 7 < c.y && c.y < 13;
      const bool is_in_border = 6 < c.x && c.x < 14 && 6 < c.y && c.y < 14 && !is_inside;
      border[t] = is_in_border ? 1 : 0;
    }
    regions = segment_model(plane, border);
  }
  Point centroid(TriangleId t) const {
    const auto& [a, b, c] = plane.triangles[t];
    return (plane.points[a] + plane.points[b] + plane.points[c]) / 3;
  }
  // Samples of the square from `low` to `high`, one unit apart, at a height.
  Flags told(double low, double high, double height, const SampledRegionOptions& options = {}) {
    std::vector<Point> samples;
    for (double x = low; x <= high; ++x) {
      for (double y = low; y <= high; ++y) samples.push_back({x, y, height});
    }
    const std::vector<RegionId> asked = {RegionId(0U), RegionId(1U)};
    return regions_under_samples(model, regions, asked, {samples, 1}, options).raw();
  }
};

TEST(SampledRegions, AreThoseUnderTheSamples) {
  SquareOnAPlane scene;
  ASSERT_EQ(scene.regions.regions.size(), 2U);
  for (const double height : {0.0, 3.0, -5.0}) {
    EXPECT_EQ(scene.told(7, 13, height), (Flags{0, 1})) << height;
  }
}

TEST(SampledRegions, AreNotToldByTooFewOrTooManySamples) {
  SquareOnAPlane scene;
  EXPECT_TRUE(scene.told(0, 20, 1).empty());    // over all
  EXPECT_TRUE(scene.told(9.5, 10, 1).empty());  // over a part of the square
  EXPECT_EQ(scene.told(9.5, 10, 1, {.min_share = 0.05}), (Flags{0, 1}));
  EXPECT_TRUE(scene.told(-9, -8, 1).empty());  // over none
  EXPECT_TRUE(scene.told(1, 0, 1).empty());    // no samples
  EXPECT_TRUE(scene.told(4, 16, 1, {.max_outside_share = 0.1}).empty());
}

TEST(SampledRegions, AreAskedForByTheirNumbers) {
  SquareOnAPlane scene;
  const std::vector<RegionId> asked = {RegionId(2U)};
  EXPECT_THROW(regions_under_samples(scene.model, scene.regions, asked, {}), InputError);
}

}  // namespace
}  // namespace cocoon
