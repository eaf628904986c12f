#include "update/model/sample_heights.h"

#include <gtest/gtest.h>
#include <limits>
#include <vector>

#include "tests/update/hand_made_models.h"

namespace cocoon {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
const std::vector<Point> over_plane = {{5, 5, 0}, {5, 6, 0.5}, {6, 5, -1.5}, {6, 6, 4}};

TEST(SampleHeights, AreSquaresUpToTheBound) {
  const TriangleMesh plane = testing::grid_plane(10);
  const ModelIndex model(plane);
  EXPECT_EQ(squared_heights(model, over_plane, 2), (std::vector<double>{0, 0.25, 2.25, infinity}));
  EXPECT_EQ(samples_off_model(model, over_plane, 1), (std::vector{over_plane[2], over_plane[3]}));
}

// A place is near if it is so as it lies, or moved back, however far it is moved.
TEST(SampleHeights, AreTheLesserOfAPlaceAndItMovedBack) {
  const TriangleMesh plane = testing::grid_plane(10);
  const ModelIndex model(plane);
  const Vec3 shift = {0, 0, 3.5};
  const std::vector<double> expected = {0, 0.25, 2.25, 0.25};
  EXPECT_EQ(squared_heights(model, over_plane, 2, shift), expected);
  SampleHeights heights(model, over_plane, over_plane, 1, 2, shift);
  for (std::size_t k = 0; k < expected.size(); ++k) {
    EXPECT_EQ(heights.squared(PointId(k)), expected[k]);
  }
  EXPECT_EQ(samples_off_model(model, over_plane, 1, shift), std::vector{over_plane[2]});
}

}  // namespace
}  // namespace cocoon
