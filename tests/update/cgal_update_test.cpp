// The plain update on CGAL's triangulation, which `./dev bench paper` measures against, does the
// same job.
#include "ref/cgal_update.h"

#include <algorithm>
#include <array>
#include <gtest/gtest.h>
#include <iterator>
#include <set>
#include <vector>

#include "cocone/reconstruct.h"
#include "geom/mesh_measure.h"
#include "io/sample_models.h"
#include "ref/cgal_surface.h"
#include "tests/cocone/sample_shapes.h"
#include "update/update_model.h"

namespace cocoon {
namespace {

const SampleModel& block() {
  static const SampleModel model = sample_model("block");
  return model;
}

std::set<std::array<PointId, 3>> sorted(const std::vector<std::array<PointId, 3>>& triangles) {
  std::set<std::array<PointId, 3>> result;
  for (auto triangle : triangles) {
    std::sort(triangle.begin(), triangle.end());
    result.insert(triangle);
  }
  return result;
}

std::set<std::array<PointId, 3>> sorted(const ReconstructResult& result) {
  std::vector<std::array<PointId, 3>> triangles;
  for (const auto& [a, b, c] : result.mesh.triangles) {
    const auto& point_of = result.point_of_vertex;
    triangles.push_back({point_of[a], point_of[b], point_of[c]});
  }
  return sorted(triangles);
}

TEST(CgalSurface, TightSurfaceIsOurs) {
  const auto& points = block().initial;
  const ref::CgalSurface plain = ref::cgal_tight_surface(points);
  EXPECT_EQ(sorted(plain.triangles), sorted(reconstruct_tight(points)));
  TriangleMesh mesh;
  mesh.points = IdVector<VertexId, Point>(points);
  for (const auto& [a, b, c] : plain.triangles) {
    mesh.triangles.push_back({VertexId(a.value), VertexId(b.value), VertexId(c.value)});
  }
  EXPECT_GT(mesh_measure(mesh).signed_volume, 0) << "oriented outward";
}

TEST(CgalSurface, OpenSurfaceIsOurs) {
  const auto& points = block().clouds[0];
  ReconstructOptions options = open_cloud_defaults();
  options.boundary.rho = 0.3;
  options.boundary.radius_mode = RadiusMode::cocone;
  const ref::CgalSurface plain =
      ref::cgal_open_surface(points, {.rho = 0.3, .tangent_plane_radius = false});
  EXPECT_EQ(sorted(plain.triangles), sorted(reconstruct_cocone(points, options)));
}

// Holes that the peel closes by small triangles, candidates at sharp edges, boundary samples. Stage
// by stage: tests/cocone/plain_stages_test.cpp.
TEST(CgalSurface, IsOursWhereTheSurfaceHasHoles) {
  ReconstructOptions paper;
  paper.mode = Mode::paper;
  for (const auto& points : {shapes::cut_sphere(1000, 0.5, 9), shapes::cut_sphere(1000, 0.0, 9),
                             shapes::dome_patch(25, 0.5, 8), shapes::random_torus(500, 0.4, 7)}) {
    const ReconstructResult open = reconstruct_cocone(points, paper);
    const ref::CgalCoconeOptions plain = {.tangent_plane_radius = false};
    EXPECT_GT(open.counters.boundary_samples, 20U);
    EXPECT_GT(open.mesh.triangles.size(), 900U);
    EXPECT_EQ(sorted(ref::cgal_open_surface(points, plain).triangles), sorted(open));
    const ReconstructResult tight = reconstruct_tight(points, paper);
    EXPECT_GT(tight.counters.poor_cells, 5U);
    EXPECT_GT(tight.mesh.triangles.size(), open.mesh.triangles.size());
    EXPECT_EQ(sorted(ref::cgal_tight_surface(points, plain).triangles), sorted(tight));
  }
}

// What one of them has and the other one has not.
template <class Id>
std::vector<Id> difference(const std::vector<Id>& a, const std::vector<Id>& b) {
  std::vector<Id> result;
  std::set_symmetric_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(result));
  return result;
}

TEST(CgalUpdate, ReplacesTheSamePoints) {
  const TriangleMesh model = reconstruct_tight(block().initial).mesh;
  const ref::CgalUpdate plain = ref::cgal_update(model, block().clouds);
  for (const UpdateOptions& options : {UpdateOptions(), paper_update_options()}) {
    const UpdateResult ours = update_model(model, block().clouds, options);
    ASSERT_EQ(ours.status, UpdateStatus::ok);
    EXPECT_EQ(plain.rim_points, ours.clouds[0].boundary_points);
    EXPECT_EQ(plain.overlapping_facets, ours.clouds[0].overlapping_facets);
    EXPECT_EQ(plain.regions, ours.regions.regions.size());
    EXPECT_GT(plain.replaced.size(), 400U);
    EXPECT_EQ(plain.replaced, ours.replacement.vertices.removed);
    EXPECT_NEAR(static_cast<double>(plain.mesh.triangles.size()),
                static_cast<double>(ours.mesh.triangles.size()), 40);
  }
}

// The corners of these facets and of those that touch them, ascending.
std::vector<VertexId> corners_around(const TriangleMesh& model,
                                     const std::vector<TriangleId>& facets) {
  std::set<VertexId> own;
  for (const TriangleId t : facets)
    own.insert(model.triangles[t].begin(), model.triangles[t].end());
  std::set<VertexId> all;
  for (const Triangle& t : model.triangles) {
    if (std::any_of(t.begin(), t.end(), [&](VertexId v) { return own.count(v) != 0; })) {
      all.insert(t.begin(), t.end());
    }
  }
  return {all.begin(), all.end()};
}

// It closes gaps of the border by the fewest facets, ours by straight walks, and it keeps vertices
// of the border: there alone may they differ. The rims and the facets under their points are the
// same.
TEST(CgalUpdate, DiffersFromOursAtTheBorderAlone) {
  const SampleModel sample = sample_model("joystick-2", {.points = 9000, .cloud_points = 8000});
  const TriangleMesh model = reconstruct_tight(sample.initial).mesh;
  const UpdateResult ours = update_model(model, sample.clouds, paper_update_options());
  ASSERT_EQ(ours.status, UpdateStatus::ok);
  const ref::CgalUpdate plain = ref::cgal_update(model, sample.clouds);
  EXPECT_EQ(plain.rim_points, ours.clouds[0].boundary_points);
  EXPECT_EQ(plain.overlapping_facets, ours.clouds[0].overlapping_facets);
  EXPECT_EQ(plain.regions, ours.regions.regions.size());
  EXPECT_GT(plain.replaced.size(), 800U);
  const std::vector<VertexId> different =
      difference(plain.replaced, ours.replacement.vertices.removed);
  EXPECT_LE(different.size(), 4U);
  const std::vector<VertexId> border = corners_around(model, plain.overlapping_facets);
  EXPECT_LT(10 * border.size(), model.points.size());
  for (const VertexId v : different) {
    EXPECT_TRUE(std::binary_search(border.begin(), border.end(), v)) << v.value;
  }
}

}  // namespace
}  // namespace cocoon
