#include "geom/working_scale.h"

#include <gtest/gtest.h>
#include <limits>
#include <string>
#include <vector>

#include "geom/errors.h"

namespace cocoon {
namespace {

double scale_of(std::vector<Point> points) { return working_scale(points); }

TEST(WorkingScale, LeavesOrdinarySizesAlone) {
  EXPECT_EQ(scale_of({}), 1);
  EXPECT_EQ(scale_of({{0, 0, 0}}), 1);
  EXPECT_EQ(scale_of({{1e-20, 0, 0}, {5e6, -4e5, 0.001}}), 1);
  EXPECT_EQ(scale_of({{0x1p100, 0, 0}}), 1);
}

TEST(WorkingScale, BringsTheLargestCoordinateNearOne) {
  EXPECT_EQ(scale_of({{0, -0x1.8p101, 0}}), 0x1p-101);
  EXPECT_EQ(scale_of({{0x1p-400, 0, 0x1p-700}}), 0x1p400);
  EXPECT_EQ(scale_of({{0x1p1023, 0, 0}}), 0x1p-1022);  // the smallest normal number
}

TEST(WorkingScale, SaysWhenItWouldLoseBits) {
  const std::vector<Point> near = {{1e150, 2e149, -3e140}};
  EXPECT_TRUE(scales_exactly(near, working_scale(near)));
  const std::vector<Point> far = {{1e300, 0, 0}, {1e-20, 0, 0}};
  EXPECT_FALSE(scales_exactly(far, working_scale(far)));
  const std::vector<Point> subnormal = {{std::numeric_limits<double>::denorm_min(), 0, 0}};
  EXPECT_TRUE(scales_exactly(subnormal, 0x1p1022));
}

TEST(WorkingScale, NamesAPointBesideWhichTheOthersVanish) {
  std::vector<Point> points = {{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {0, 0x1p-10, 0}, {1e60, 2, 3}};
  EXPECT_NO_THROW(require_comparable_sizes(points));
  EXPECT_NO_THROW(require_comparable_sizes({}));
  EXPECT_NO_THROW(require_comparable_sizes(std::vector<Point>{{}, {}, {1, 0, 0}}));
  points.insert(points.begin() + 2, {0, -1e90, 0});
  std::string message;
  try {
    require_comparable_sizes(points);  // of as many far ones as near ones nothing is said
    points.push_back({0, 3, 0});
    require_comparable_sizes(points);
  } catch (const InputError& error) {
    message = error.what();
  }
  EXPECT_EQ(points.size(), 7U);
  EXPECT_EQ(message.find("point 2 at (0, -1e+90, 0) is more than 2^200"), 0U) << message;
}

}  // namespace
}  // namespace cocoon
