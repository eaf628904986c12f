#include "cocone/steps/surface_result.h"

#include <gtest/gtest.h>
#include <utility>
#include <vector>

#include "cocone/steps/triangulate_points.h"
#include "geom/errors.h"
#include "tests/cocone/sample_shapes.h"

namespace cocoon {
namespace {

// Of 200 different points, of which one is there twice.
std::vector<Point> sphere() {
  std::vector<Point> points = shapes::sphere(200, 1, 0x1p+300);
  points.push_back(points[0]);
  return points;
}

class SurfaceOfASphere : public testing::Test {
 protected:
  SurfaceMesh hull() {
    return surface_of(input().triangulation, found_.surface.triangles, found_.surface.halves);
  }
  ReconstructInput input() const { return {triangulation_, points_, options_}; }

  std::vector<Point> points_ = sphere();
  ReconstructOptions options_ = effective_options({.verify = true});
  Triangulation triangulation_ = triangulate_points(points_).triangulation;
  ReconstructCounters counters_;
  FoundSurface found_ = find_surface(input(), counters_, nullptr, {});
};

TEST_F(SurfaceOfASphere, BeginsWithWhatThereIs) {
  points_.push_back(points_[0]);
  EXPECT_THROW(begin_result(input()), InputError);
  triangulation_ = triangulate_points(points_).triangulation;
  const ReconstructResult result = begin_result(input()).result;
  EXPECT_EQ(result.points, 202U);
  EXPECT_EQ(result.duplicates, 2U);
  EXPECT_EQ(result.vertices, 200U);
  EXPECT_EQ(result.tetrahedra, triangulation_.num_finite_cells());
  EXPECT_TRUE(result.mesh.triangles.empty());
}

TEST_F(SurfaceOfASphere, HasTheUsersCoordinates) {
  SurfaceResult made = begin_result(input());
  enter_mesh(input(), found_, hull(), made, {});
  EXPECT_EQ(made.result.status, SurfaceStatus::ok);
  EXPECT_EQ(made.result.unused_points, 0U);
  ASSERT_EQ(made.result.mesh.points.size(), 200U);
  for (const VertexId v : made.result.mesh.points.ids()) {
    EXPECT_EQ(made.result.mesh.points[v], points_[made.result.point_of_vertex[v].index()]);
    EXPECT_EQ(made.result.normals[v], found_.poles.normals[made.triangulation_vertex[v]]);
  }
  verify_result(input(), SurfaceKind::closed, made, {});
  EXPECT_TRUE(made.result.verification.ok());
}

TEST_F(SurfaceOfASphere, AnEmptyOneHasTheStatusThatSaysWhy) {
  SurfaceResult made = begin_result(input());
  enter_mesh(input(), found_, {}, made, {});
  EXPECT_EQ(made.result.status, SurfaceStatus::empty);
  EXPECT_EQ(made.result.unused_points, 200U);
  found_.boundary.count = found_.boundary.boundary.size();
  enter_mesh(input(), found_, {}, made, {});
  EXPECT_EQ(made.result.status, SurfaceStatus::no_surface);
}

TEST_F(SurfaceOfASphere, WhatIsRefutedIsTakenBackIfAskedFor) {
  SurfaceMesh torn = hull();
  torn.mesh.triangles.resize(torn.mesh.triangles.size() - 1);
  SurfaceResult made = begin_result(input());
  enter_mesh(input(), found_, torn, made, {});
  options_.verify = false;
  verify_result(input(), SurfaceKind::closed, made, {});
  EXPECT_EQ(made.result.status, SurfaceStatus::ok);
  options_.verify = true;
  verify_result(input(), SurfaceKind::open, made, {});
  EXPECT_EQ(made.result.status, SurfaceStatus::ok);
  verify_result(input(), SurfaceKind::closed, made, {});
  EXPECT_EQ(made.result.status, SurfaceStatus::refuted);
  EXPECT_TRUE(made.result.mesh.triangles.empty());
  EXPECT_TRUE(made.result.point_of_vertex.empty());
  EXPECT_TRUE(made.result.normals.empty());
}

}  // namespace
}  // namespace cocoon
