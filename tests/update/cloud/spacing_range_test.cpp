#include "update/cloud/spacing_range.h"

#include <cmath>
#include <gtest/gtest.h>

#include "geom/ids.h"

namespace cocoon {
namespace {

// A strip of squares, each `growth` times as long as the one before; cut along diagonals.
TriangleMesh strip(int squares, double growth) {
  TriangleMesh mesh;
  double x = 0;
  double length = 1;
  for (int i = 0; i <= squares; ++i) {
    mesh.points.push_back({x, 0, 0});
    mesh.points.push_back({x, length, 0});
    x += length;
    length *= growth;
  }
  for (std::uint32_t i = 0; i < 2 * static_cast<std::uint32_t>(squares); ++i) {
    mesh.triangles.push_back({VertexId(i), VertexId(i + 1), VertexId(i + 2)});
  }
  return mesh;
}

TEST(SpacingRange, OfAnEvenStripIsOneLength) {
  const SpacingRange range = spacing_range(strip(100, 1));
  EXPECT_NEAR(range.low, (4 + 2 * std::sqrt(2)) / 6, 0.1);
  EXPECT_NEAR(range.high, range.low, 0.1);
  EXPECT_FALSE(range.is_uneven(2));
}

TEST(SpacingRange, GrowsWithTheSamples) {
  const SpacingRange range = spacing_range(strip(100, 1.02));
  EXPECT_NEAR(range.high / range.low, std::pow(1.02, 80), 0.3);
  EXPECT_TRUE(range.is_uneven(2));
  EXPECT_FALSE(spacing_range(strip(100, 1.005)).is_uneven(2));
}

TEST(SpacingRange, OfNothingIsNothing) {
  TriangleMesh points_alone;
  points_alone.points.push_back({1, 2, 3});
  for (const TriangleMesh& mesh : {TriangleMesh(), points_alone}) {
    EXPECT_EQ(spacing_range(mesh).high, 0);
    EXPECT_FALSE(spacing_range(mesh).is_uneven(2));
  }
}

}  // namespace
}  // namespace cocoon
