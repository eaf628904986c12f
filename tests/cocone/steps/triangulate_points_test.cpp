#include "cocone/steps/triangulate_points.h"

#include <gtest/gtest.h>
#include <limits>
#include <string>
#include <vector>

#include "geom/errors.h"
#include "tests/cocone/sample_shapes.h"

namespace cocoon {
namespace {

TEST(TriangulatePoints, PointsOfAnySizeHaveTheSameCells) {
  const std::vector<Point> points = shapes::sphere(200, 1);
  const Triangulation expected = delaunay(points).triangulation;
  for (const double scale : {1.0, 0x1p+600, 0x1p-600}) {
    std::vector<Point> scaled = points;
    for (Point& p : scaled) p = scale * p;
    const DelaunayResult built = triangulate_points(scaled);
    ASSERT_EQ(built.triangulation.num_cells(), expected.num_cells());
    for (const CellId c : expected.cells()) {
      EXPECT_EQ(built.triangulation.cell(c), expected.cell(c));
    }
  }
}

TEST(TriangulatePoints, WhatLosesBitsIsRefused) {
  std::vector<Point> points = shapes::sphere(50, 1);
  for (Point& p : points) p = 0x1p+600 * p;
  points[0].x = 0x1p-500;
  EXPECT_THROW(triangulate_points(points), InputError);
  points[0].x = std::numeric_limits<double>::infinity();
  try {
    triangulate_points(points);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("not finite"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace cocoon
