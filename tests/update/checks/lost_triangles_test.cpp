#include "update/checks/lost_triangles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <iterator>
#include <vector>

#include "geom/errors.h"
#include "update/model/mesh_change.h"

namespace cocoon {
namespace {

TriangleMesh mesh_of(std::size_t points, const std::vector<std::array<std::size_t, 3>>& triangles) {
  TriangleMesh mesh;
  for (std::size_t i = 0; i < points; ++i) mesh.points.push_back({static_cast<double>(i), 0, 0});
  for (const auto& [a, b, c] : triangles) {
    mesh.triangles.push_back({VertexId(a), VertexId(b), VertexId(c)});
  }
  return mesh;
}

// Of four triangles one has a vertex that goes; of the others one comes back with its corners in
// another order, one is turned over, and one is not there.
TEST(LostTriangles, CountsThoseWhoseVerticesStay) {
  TriangleMesh model = mesh_of(6, {{0, 1, 2}, {2, 1, 3}, {3, 4, 0}, {4, 5, 0}});
  model.points[VertexId(3U)].y = 4;  // the other three that stay are in line
  IdVector<VertexId, VertexId> map;
  for (const std::size_t v : {4U, 3U, 2U, 1U, 0U}) map.push_back(VertexId(v));
  map.push_back(VertexId());
  const TriangleMesh updated = mesh_of(6, {{2, 4, 3}, {5, 2, 1}, {0, 1, 4}});
  IdVector<VertexId, PointId> points;
  for (const std::size_t p : {0U, 1U, 2U, 3U, 4U}) points.push_back(PointId(p));
  points.push_back(PointId());
  const LostTriangles lost =
      lost_triangles(model, points, mesh_change(model, updated, map).triangle_map);
  EXPECT_EQ(lost.staying, 3U);
  EXPECT_EQ(lost.staying_area, 0 + 2 + 8);
  const std::vector<TriangleId> expected = {TriangleId(std::size_t{1}), TriangleId(std::size_t{2})};
  EXPECT_EQ(lost.lost, expected);
}

// A vertex that stays as a point, but is not on the new surface, takes its triangles with it.
TEST(LostTriangles, CountsThoseAtVerticesThatAreNotUsed) {
  const TriangleMesh model = mesh_of(4, {{0, 1, 2}, {2, 1, 3}});
  IdVector<VertexId, VertexId> map;
  IdVector<VertexId, PointId> points;
  for (std::size_t v = 0; v < 4; ++v) {
    map.push_back(v < 3 ? VertexId(v) : VertexId());
    points.push_back(PointId(v));
  }
  const TriangleMesh updated = mesh_of(3, {{0, 1, 2}});
  const LostTriangles lost =
      lost_triangles(model, points, mesh_change(model, updated, map).triangle_map);
  EXPECT_EQ(lost.staying, 2U);
  EXPECT_EQ(lost.lost, std::vector<TriangleId>{TriangleId(std::size_t{1})});
}

TEST(LostTriangles, NoneOfNothing) {
  const LostTriangles lost = lost_triangles({}, {}, {});
  EXPECT_EQ(lost.staying, 0U);
  EXPECT_TRUE(lost.lost.empty());
}

// A square cut along its other diagonal is the same surface; one that is bent there is not.
TEST(LostTriangles, AnotherDiagonalIsNotAstray) {
  TriangleMesh model = mesh_of(4, {{0, 1, 2}, {0, 2, 3}});
  const Point corners[] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  std::copy(std::begin(corners), std::end(corners), model.points.begin());
  TriangleMesh updated = model;
  updated.triangles.clear();
  updated.triangles.push_back({VertexId(0U), VertexId(1U), VertexId(3U)});
  updated.triangles.push_back({VertexId(1U), VertexId(2U), VertexId(3U)});
  const std::vector<TriangleId> both = {TriangleId(std::size_t{0}), TriangleId(std::size_t{1})};
  EXPECT_EQ(astray_triangles(model, both, updated, {}).count, 0U);
  model.points[VertexId(2U)].z = 1;
  const AstrayTriangles astray = astray_triangles(model, both, updated, {});
  EXPECT_EQ(astray.count, 2U);
  EXPECT_NEAR(astray.area, std::sqrt(2), 1e-12);
  EXPECT_NEAR(astray.median_longest_edge, std::sqrt(3), 1e-12);
  EXPECT_EQ(astray.largest, both[0]);
  EXPECT_EQ(astray_triangles(model, both, updated, {}, {.tolerance = 0.5}).area, 0);
}

// Of a CAD mesh most triangles may be small, and most of its surface is in a few large ones.
TEST(LostTriangles, TheMedianLengthIsByArea) {
  TriangleMesh model = mesh_of(9, {{0, 1, 2}, {3, 4, 5}, {6, 7, 8}});
  const Point corners[] = {{0, 0, 0},  {1, 0, 0},  {0, 1, 0},  {20, 0, 0}, {30, 0, 0},
                           {20, 9, 0}, {50, 0, 0}, {51, 0, 0}, {50, 1, 0}};
  std::copy(std::begin(corners), std::end(corners), model.points.begin());
  TriangleMesh updated = model;
  for (Point& p : updated.points) p.z = 5;
  std::vector<TriangleId> all;
  for (const TriangleId t : model.triangles.ids()) all.push_back(t);
  const AstrayTriangles astray = astray_triangles(model, all, updated, {});
  EXPECT_EQ(astray.count, 3U);
  EXPECT_NEAR(astray.median_longest_edge, std::hypot(10, 9), 1e-12);
}

// Where something was scanned the surface may be another one.
TEST(LostTriangles, ScannedPlacesAreNotAstray) {
  TriangleMesh model = mesh_of(6, {{0, 1, 2}, {3, 4, 5}});
  const Point corners[] = {{0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {10, 0, 0}, {13, 0, 0}, {10, 3, 0}};
  std::copy(std::begin(corners), std::end(corners), model.points.begin());
  TriangleMesh updated = model;
  for (Point& p : updated.points) p.z = 1;
  const std::vector<Point> samples = {{1, 1, 1.5}};
  const std::vector<TriangleId> both = {TriangleId(std::size_t{0}), TriangleId(std::size_t{1})};
  const Scan near[] = {{samples, 0.6}};
  const AstrayTriangles astray = astray_triangles(model, both, updated, near);
  EXPECT_EQ(astray.count, 1U);
  EXPECT_EQ(astray.largest, both[1]);
  EXPECT_NEAR(astray.area, 4.5, 1e-12);
  const Scan too_far[] = {{samples, 0.4}};
  EXPECT_EQ(astray_triangles(model, both, updated, too_far).count, 2U);
}

// A plate thinner than a share of its long triangles, of which the lower side is gone.
TEST(LostTriangles, ToleranceIsBoundedBySpacingsOfTheScans) {
  TriangleMesh model = mesh_of(6, {{0, 1, 2}, {3, 5, 4}});
  const Point corners[] = {{0, 0, 1}, {30, 0, 1}, {0, 30, 1}, {0, 0, 0}, {30, 0, 0}, {0, 30, 0}};
  std::copy(std::begin(corners), std::end(corners), model.points.begin());
  TriangleMesh updated = model;
  updated.triangles.raw().pop_back();
  const std::vector<TriangleId> both = {TriangleId(std::size_t{0}), TriangleId(std::size_t{1})};
  const std::vector<Point> samples = {{28, 1, 1}};
  const Scan scans[] = {{samples, 0.3}};
  EXPECT_EQ(astray_triangles(model, both, updated, {}).count, 0U);
  const AstrayTriangles astray = astray_triangles(model, both, updated, scans);
  EXPECT_EQ(astray.count, 1U);
  EXPECT_EQ(astray.largest, both[1]);
  EXPECT_NEAR(astray.area, 450, 1e-9);
  EXPECT_EQ(astray_triangles(model, both, updated, scans, {.most_spacings = 5}).count, 0U);
}

// A disk's diameter, wherever it lies, with strays or not; of several scans the smallest, but the
// largest spacing.
TEST(LostTriangles, AreLargeForTheScansAndForTheChange) {
  std::vector<Point> disk;
  for (int i = 0; i < 2000; ++i) {
    const double radius = 2 * std::sqrt((i + 0.5) / 2000);
    disk.push_back({7 + radius * std::cos(2.4 * i), -3, radius * std::sin(2.4 * i)});
  }
  for (int i = 0; i < 20; ++i) disk.push_back({1e6, i * 1e5, 0});  // strays
  const std::vector<Point> line = {{0, 0, 0}, {0, 0, 0}, {50, 0, 0}, {50, 0, 0}};
  const Scan fine[] = {{disk, 0.01}, {line, 0.02}};
  const Scan coarse[] = {{disk, 0.01}, {line, 0.2}};
  EXPECT_NEAR(large_side(fine), 0.1 * 4, 0.01);
  EXPECT_DOUBLE_EQ(large_side(coarse), 3 * 0.2);
  EXPECT_NEAR(large_side(fine, {.min_extent_share = 0.5}), 2, 0.05);
  EXPECT_EQ(large_side({}), 0);
  EXPECT_THROW(large_side(fine, {.min_extent_share = 2}), InputError);
}

}  // namespace
}  // namespace cocoon
