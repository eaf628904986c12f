// A pocket with sharp edges, scanned as scanners do: from several sides, none of which sees all of
// it.
#include <algorithm>
#include <gtest/gtest.h>
#include <utility>
#include <vector>

#include "geom/mesh_check.h"
#include "tests/end_to_end/local_update.h"
#include "tests/end_to_end/slab_with_pocket.h"
#include "update/update_model.h"

namespace cocoon {
namespace {

using testing::Clouds;
using testing::SlabWithPocket;

class UpdateViews : public ::testing::TestWithParam<std::uint64_t> {
 protected:
  SlabWithPocket slab{GetParam()};

  Clouds three_views() {
    return {slab.view({1, 0, 1.2}), slab.view({-0.5, 0.87, 1.2}), slab.view({-0.5, -0.87, 1.2})};
  }
  void expect_pocket(const Clouds& clouds, const UpdateResult& result) const {
    testing::expect_local_update(slab.model, clouds, result, SlabWithPocket::in_pocket,
                                 SlabWithPocket::is_far);
    EXPECT_EQ(mesh_check(result.mesh).euler, 2);
    EXPECT_FALSE(result.unused_changes.is_doubtful({}));
  }
};

TEST_P(UpdateViews, EachACloud) {
  const Clouds clouds = three_views();
  const UpdateResult result = update_model(slab.model, clouds);
  expect_pocket(clouds, result);
  EXPECT_EQ(result.clouds[2].joined_with, 0U);
}

TEST_P(UpdateViews, InAnyOrder) {
  Clouds clouds = three_views();
  const auto vertices = [&] {
    std::vector<Point> points = update_model(slab.model, clouds).mesh.points.raw();
    std::sort(points.begin(), points.end());
    return points;
  };
  const std::vector<Point> expected = vertices();
  std::swap(clouds[0], clouds[2]);
  std::reverse(clouds[1].begin(), clouds[1].end());
  EXPECT_EQ(vertices(), expected);
}

// Each alone is torn where the others see walls: what goes wrong is told.
TEST_P(UpdateViews, EachACloudAndASurface) {
  const Clouds clouds = three_views();
  UpdateOptions options;
  options.join.reach = 0;
  const UpdateResult result = update_model(slab.model, clouds, options);
  ASSERT_EQ(result.status, UpdateStatus::ok);
  EXPECT_TRUE(mesh_check(result.mesh).is_closed_manifold());
  const bool is_right = slab.left_over(result) < 10 && mesh_check(result.mesh).euler == 2;
  EXPECT_TRUE(is_right || !result.warnings.empty());
}

// Of joined clouds hardly a sample is left: each has its own surface again.
TEST_P(UpdateViews, JoinedInVain) {
  const Clouds clouds = three_views();
  UpdateOptions options;
  options.join.thinning = 1000;
  const UpdateResult result = update_model(slab.model, clouds, options);
  options.join.reach = 0;
  const UpdateResult apart = update_model(slab.model, clouds, options);
  ASSERT_EQ(result.status, UpdateStatus::ok);
  EXPECT_EQ(result.mesh.triangles, apart.mesh.triangles);
  ASSERT_FALSE(result.warnings.empty());
  EXPECT_TRUE(
      result.warnings.front().starts_with("clouds overlap each other, but do not make one"));
}

// Layers a third of the spacing apart.
TEST_P(UpdateViews, OutOfRegisterInOneCloud) {
  Clouds clouds(1);
  double off = -0.3 * SlabWithPocket::least;
  for (const std::vector<Point>& view : three_views()) {
    for (const Point& p : view) clouds[0].push_back(p + Vec3{off, -off, off});
    off += 0.3 * SlabWithPocket::least;
  }
  const UpdateResult result = update_model(slab.model, clouds);
  expect_pocket(clouds, result);
  EXPECT_GT(result.clouds[0].surface.set_aside, clouds[0].size() / 4);
  EXPECT_TRUE(result.clouds[0].surface.is_layered);

  UpdateOptions options;
  options.cloud.layers.spread = 0;
  const UpdateResult layered = update_model(slab.model, clouds, options);
  EXPECT_TRUE(layered.status != UpdateStatus::ok ||
              layered.warnings.size() > result.warnings.size());
}

// The floor, and none of the walls: ten spacings down, nothing between.
TEST_P(UpdateViews, FromAbove) {
  const Clouds clouds = {slab.view({0, 0, 1})};
  const UpdateResult result = update_model(slab.model, clouds);
  ASSERT_EQ(result.status, UpdateStatus::ok);
  EXPECT_TRUE(mesh_check(result.mesh).is_closed_manifold());
  EXPECT_EQ(mesh_check(result.mesh).euler, 2);
  EXPECT_LE(slab.left_over(result), 2U);
  EXPECT_LT(result.unused_changes.samples, 10U);
  EXPECT_EQ(result.unscanned.vertices, 0U);
  EXPECT_EQ(result.islands.size(), 1U);

  UpdateOptions options;
  options.islands.min_samples = 1000000;
  const UpdateResult filled = update_model(slab.model, clouds, options);
  EXPECT_GT(slab.left_over(filled), 100U);
  EXPECT_TRUE(filled.unused_changes.is_doubtful({}));
}

INSTANTIATE_TEST_SUITE_P(Scans, UpdateViews, ::testing::Values(1, 2, 3));

}  // namespace
}  // namespace cocoon
