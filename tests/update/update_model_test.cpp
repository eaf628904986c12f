// What becomes of an update whose clouds are refused as they are.
#include "update/update_model.h"

#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "cocone/reconstruct.h"
#include "tests/layered_views.h"

namespace cocoon {
namespace {

TEST(UpdateModel, RimsOfLayersThatAreRefusedAreLookedForAmongFewSamples) {
  Random random(5);
  const std::vector<Point> ball = test::noisy_ball(0, random);
  const TriangleMesh model = reconstruct_tight(ball).mesh;
  UpdateOptions once;
  once.cloud.layers.when_refused = {};
  std::size_t refused = 0;
  for (int trial = 0; trial < 8; ++trial) {
    const std::vector<std::vector<Point>> clouds = {
        test::layered_cap(0.35 * test::spacing_of_ball, random)};
    const UpdateResult all = update_model(model, clouds, once);
    const UpdateResult result = update_model(model, clouds);
    if (all.status == UpdateStatus::ok) {
      EXPECT_TRUE(result.mesh == all.mesh);
      continue;
    }
    ++refused;
    EXPECT_NE(all.message.find("lie in layers"), std::string::npos) << all.message;
    ASSERT_EQ(result.status, UpdateStatus::ok) << result.message;
    EXPECT_EQ(result.clouds[0].surface.is_layered, true);
    EXPECT_EQ(result.warnings.front().find("samples lie in layers, and their rim is refused"), 0U);
    EXPECT_GT(result.replacement.replaced, 300U);
    EXPECT_LT(result.replacement.replaced, 420U);
  }
  EXPECT_GE(refused, 2U);
}

}  // namespace
}  // namespace cocoon
