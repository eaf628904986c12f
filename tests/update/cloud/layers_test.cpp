#include "update/cloud/layers.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <vector>

#include "geom/errors.h"
#include "geom/random/random.h"

namespace cocoon {
namespace {

// Unit squares at these heights.
std::vector<Point> layers(const std::vector<double>& heights) {
  std::vector<Point> points;
  for (const double z : heights) {
    for (int x = 0; x < 20; ++x) {
      for (int y = 0; y < 20; ++y) points.push_back({double(x), double(y), z});
    }
  }
  return points;
}

std::vector<PointId> all(const std::vector<Point>& points) {
  std::vector<PointId> ids;
  for (std::size_t i = 0; i < points.size(); ++i) ids.push_back(PointId(i));
  return ids;
}

double thickness(const std::vector<Point>& points, double reach) {
  return layer_thickness(points, all(points), reach);
}

TEST(LayerThickness, OneLayerHasNoneAndSeveralHaveTheirDistance) {
  EXPECT_LT(thickness(layers({0}), 2.5), 1e-6);
  // Within 2.5 of a sample of one of two layers lie 21 of each: their second moments are those of
  // the disk, and a quarter of the squared distance.
  const double moment = (10 * 1.0 + 6 * 4.0) / 21;  // of x in the disk
  EXPECT_NEAR(thickness(layers({0, 0.4}), 2.5), 0.2 / std::sqrt(moment), 1e-12);
}

TEST(LayerThickness, IsTheSameInAnyOrderAndSize) {
  Random random(1);
  std::vector<Point> points = layers({0, 0.3, 0.8});
  for (Point& p : points) p.x += random.uniform(-0.1, 0.1);
  const double found = thickness(points, 1.8);
  EXPECT_GT(found, 0.1);
  std::reverse(points.begin(), points.end());
  EXPECT_EQ(thickness(points, 1.8), found);
  for (Point& p : points) p = std::ldexp(1.0, 100) * p;
  EXPECT_EQ(thickness(points, std::ldexp(1.8, 100)), found);
}

TEST(LayerThickness, FewSamplesAndLinesTellNothing) {
  EXPECT_EQ(thickness({}, 1), 0);
  EXPECT_EQ(thickness(layers({0, 0.4}), 0.5), 0);  // two of them
  std::vector<Point> line;
  for (int x = 0; x < 20; ++x) line.push_back({double(x), 0, 0});
  EXPECT_EQ(thickness(line, 3.5), 0);
}

TEST(LayerThickness, SamplesGivenTwiceCountOnce) {
  std::vector<Point> points = layers({0, 0.3});
  const std::vector<PointId> at = all(points);
  const double expected = layer_thickness(points, at, 2.5);
  for (int k = 0; k < 200; ++k) points.push_back(points[static_cast<std::size_t>(k)]);
  EXPECT_EQ(layer_thickness(points, at, 2.5), expected);
  const std::vector<Point> few(10, points[0]);
  EXPECT_EQ(thickness(few, 2.5), 0);
  for (const double reach : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_EQ(layer_thickness(points, at, reach), 0);
  }
  for (const double spread : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_TRUE(few_of_layers(points, spread).kept.empty());
    EXPECT_EQ(few_of_layers(points, spread).distance, 0);
  }
}

TEST(LayerThickness, RefusesWhatIsNoSample) {
  std::vector<Point> points = layers({0});
  EXPECT_THROW(layer_thickness(points, {{PointId(points.size())}}, 1), InputError);
  points[3].z = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(thickness(points, 1), InputError);
}

}  // namespace
}  // namespace cocoon
