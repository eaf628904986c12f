// What becomes of an update whose clouds are refused as they are.
#include "update/update_model.h"

#include <gtest/gtest.h>
#include <limits>
#include <string>
#include <vector>

#include "cocone/reconstruct.h"
#include "geom/errors.h"
#include "tests/gallery.h"
#include "tests/layered_views.h"

namespace cocoon {
namespace {

using Clouds = std::vector<std::vector<Point>>;

class RimsOfLayers : public testing::Test {
 protected:
  RimsOfLayers() { once_.cloud.layers.when_refused = {}; }

  // Are refused as they are.
  std::vector<std::vector<Point>> refused_caps() {
    std::vector<std::vector<Point>> refused;
    for (int trial = 0; trial < 8; ++trial) {
      std::vector<Point> cap = test::layered_cap(0.35 * test::spacing_of_ball, random_);
      const UpdateResult all = update_model(model_, {{cap}}, once_);
      if (all.status == UpdateStatus::ok) {
        EXPECT_TRUE(update_model(model_, {{cap}}).mesh == all.mesh);
        continue;
      }
      EXPECT_NE(all.message.find("cloud 1 of 1: samples lie in layers"), std::string::npos)
          << all.message;
      refused.push_back(std::move(cap));
    }
    EXPECT_GE(refused.size(), 2U);
    return refused;
  }

  UpdateOptions once_;
  Random random_ = Random(5);
  TriangleMesh model_ = reconstruct_tight(test::noisy_ball(0, random_)).mesh;
};

TEST_F(RimsOfLayers, ThatAreRefusedAreLookedForAmongFewSamples) {
  for (const std::vector<Point>& cap : refused_caps()) {
    const UpdateResult result = update_model(model_, {{cap}});
    ASSERT_EQ(result.status, UpdateStatus::ok) << result.message;
    EXPECT_TRUE(result.clouds[0].surface.is_layered);
    EXPECT_EQ(result.warnings.front().find("cloud 1 of 1: samples lie in layers, and the rim"), 0U)
        << result.warnings.front();
    EXPECT_GT(result.replacement.vertices.replaced, 300U);
    EXPECT_LT(result.replacement.vertices.replaced, 420U);
  }
}

// Few samples are farther apart, so that what is far from the model would count as near.
TEST_F(RimsOfLayers, InOtherUnitsOrOffTheModelStayRefused) {
  for (const std::vector<Point>& cap : refused_caps()) {
    std::vector<Point> larger = cap;
    for (Point& p : larger) p = 2 * p;
    EXPECT_EQ(update_model(model_, {{larger}}).status, UpdateStatus::no_overlap);
    std::vector<Point> lifted = cap;
    for (Point& p : lifted) p.z += 8 * test::spacing_of_ball;
    EXPECT_EQ(update_model(model_, {{lifted}}).status, UpdateStatus::no_overlap);
  }
}

// Another cloud of the same update is looked at as it would be alone.
TEST_F(RimsOfLayers, LeaveOtherCloudsAsTheyAre) {
  std::vector<Point> below;
  for (const Point& p : gallery::even_sphere(test::samples_of_ball)) {
    if (p.z < -0.75) below.push_back({p.y, p.x, p.z});
  }
  const UpdateResult alone = update_model(model_, {{below}});
  ASSERT_EQ(alone.status, UpdateStatus::ok) << alone.message;
  for (const std::vector<Point>& cap : refused_caps()) {
    const UpdateResult both = update_model(model_, Clouds{below, cap});
    ASSERT_EQ(both.status, UpdateStatus::ok) << both.message;
    EXPECT_FALSE(both.clouds[0].surface.is_layered);
    EXPECT_TRUE(both.clouds[0].surface.mesh == alone.clouds[0].surface.mesh);
    EXPECT_TRUE(both.clouds[1].surface.is_layered);
    EXPECT_EQ(both.warnings.front().find("cloud 2 of 2: samples lie in layers"), 0U);
  }
}

// Of clouds that fail in different ways the order does not tell how the update ends.
TEST(FailingClouds, EndAnUpdateInTheSameWayInAnyOrder) {
  const TriangleMesh model = reconstruct_tight(gallery::even_sphere(500)).mesh;
  std::vector<Point> closed;
  for (const Point& p : gallery::even_sphere(200)) {
    closed.push_back(Point{0, 0, 1.2} + 0.1 * p);
  }
  std::vector<Point> far;
  for (const Point& p : gallery::even_sphere(500)) {
    if (p.x > 0.5) far.push_back(p + Point{3, 0, 0});
  }
  const std::vector<Point> few = {{0, 0, -1}, {0, 0.1, -1}, {0.1, 0, -1}, {0, 0, -1.1}};
  const auto status_of = [&](const Clouds& clouds) { return update_model(model, clouds).status; };
  ASSERT_EQ(status_of({closed}), UpdateStatus::cloud_closed);
  ASSERT_EQ(status_of({few}), UpdateStatus::no_cloud_surface);
  ASSERT_EQ(status_of({far}), UpdateStatus::no_overlap);
  EXPECT_EQ(status_of({closed, few}), UpdateStatus::no_cloud_surface);
  EXPECT_EQ(status_of({few, closed}), UpdateStatus::no_cloud_surface);
  EXPECT_EQ(status_of({far, closed, few}), UpdateStatus::no_cloud_surface);
  EXPECT_EQ(status_of({far, closed}), UpdateStatus::cloud_closed);
  EXPECT_EQ(update_model(model, Clouds{few, few}).message.find("cloud 1 of 2 "), 0U);

  const std::vector<Point> on_a_line = {{0, 0, 1}, {0, 0, 2}, {0, 0, 3}, {0, 0, 4}, {0, 0, 5}};
  EXPECT_THROW(status_of({closed, on_a_line}), DegenerateInput);
  EXPECT_THROW(status_of({on_a_line, closed}), DegenerateInput);
}

TEST(FailingClouds, AreNotLookedAtAgainWithOneThatIsNotFinite) {
  const TriangleMesh model = reconstruct_tight(gallery::even_sphere(500)).mesh;
  std::vector<Point> endless = gallery::even_sphere(40);
  endless[7].y = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(update_model(model, Clouds{gallery::even_sphere(200), endless}), InputError);
}

}  // namespace
}  // namespace cocoon
