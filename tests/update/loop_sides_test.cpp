#include "update/loop_sides.h"

#include <cmath>
#include <gtest/gtest.h>

#include "tests/update/hand_made_models.h"
#include "update/overlapping_facets.h"

namespace cocoon {
namespace {

using testing::circle;
using testing::rim_of;

struct Traced {
  Border border;
  Regions regions;
  std::vector<LoopSides> sides;
};

Traced trace(const TriangleMesh& mesh, const CloudRim& rim) {
  const ModelIndex model(mesh);
  const Overlap overlap = overlapping_facets(model, rim);
  EXPECT_EQ(overlap.status, OverlapStatus::ok);
  Traced traced;
  traced.border = trace_border(model, rim, overlap);
  traced.regions = segment_model(mesh, traced.border.facets);
  for (const LoopBorder& band : traced.border.loops) {
    traced.sides.push_back(loop_sides(mesh, model.adjacency(), band, traced.regions));
  }
  return traced;
}

// The circle around the tube of the torus at angle u, as the rim of a membrane across the tube.
RimLoop meridian(double u, double tube, std::size_t n) {
  std::vector<Point> points;
  std::vector<Vec3> normals;
  for (std::size_t j = 0; j < n; ++j) {
    const double v = 2 * std::numbers::pi * (static_cast<double>(j) + 0.3) / static_cast<double>(n);
    points.push_back(testing::torus_point(u, v, tube));
    normals.push_back(unit(points.back() - testing::torus_point(u, v, 0)));
  }
  const Point center = testing::torus_point(u, 0, 0);
  return testing::loop_towards(points, normals, center);
}

TEST(LoopSides, ACapHasTwoSides) {
  const TriangleMesh mesh = testing::sphere(4);
  const Traced traced = trace(mesh, rim_of({testing::cap_rim(50, {0, 0, 1}, 0.8)}));
  ASSERT_EQ(traced.sides[0].separation, Separation::separates);
  ASSERT_GE(traced.sides[0].sides.size(), 2U);
  EXPECT_NE(traced.sides[0].sides[0].region, traced.sides[0].sides[1].region);
}

TEST(LoopSides, RimWithinOneFacetEnclosesNothing) {
  const TriangleMesh mesh = testing::grid_plane(10);
  const Traced traced = trace(mesh, rim_of({circle(12, {4.7, 4.3, 0.02}, 0.15)}));
  EXPECT_EQ(traced.border.num_facets, 1U);
  EXPECT_EQ(traced.sides[0].separation, Separation::encloses_nothing);
}

TEST(LoopSides, RimAroundOneVertexEnclosesNothing) {
  const TriangleMesh mesh = testing::grid_plane(10);
  const Traced traced = trace(mesh, rim_of({circle(24, {5, 5, 0.02}, 0.4)}));
  EXPECT_EQ(traced.border.num_facets, 6U);
  EXPECT_EQ(traced.sides[0].separation, Separation::encloses_nothing);
  EXPECT_EQ(traced.regions.border_vertices, 1U);
}

TEST(LoopSides, AMembraneAcrossATubeDoesNotSeparate) {
  const TriangleMesh mesh = testing::torus(60, 24, 0.3);
  const Traced traced = trace(mesh, rim_of({meridian(0.31, 0.3, 40)}));
  EXPECT_EQ(traced.regions.regions.size(), 1U);
  EXPECT_EQ(traced.sides[0].separation, Separation::non_separating);
}

TEST(LoopSides, TwoMeridiansSeparateTogether) {
  const TriangleMesh mesh = testing::torus(60, 24, 0.3);
  const Traced traced = trace(mesh, rim_of({meridian(0.31, 0.3, 40), meridian(1.27, 0.3, 40)}));
  EXPECT_EQ(traced.regions.regions.size(), 2U);
  EXPECT_EQ(traced.sides[0].separation, Separation::separates);
  EXPECT_EQ(traced.sides[1].separation, Separation::separates);
}

}  // namespace
}  // namespace cocoon
