#include "update/regions/loop_sides.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <gtest/gtest.h>
#include <numbers>
#include <vector>

#include "geom/mesh/triangle_neighbors.h"
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
    traced.sides.push_back(loop_sides(mesh, model.neighbors(), band, traced.regions));
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
  EXPECT_EQ(traced.border.figures.facets, 1U);
  EXPECT_EQ(traced.sides[0].separation, Separation::encloses_nothing);
}

TEST(LoopSides, RimAroundOneVertexEnclosesNothing) {
  const TriangleMesh mesh = testing::grid_plane(10);
  const Traced traced = trace(mesh, rim_of({circle(24, {5, 5, 0.02}, 0.4)}));
  EXPECT_EQ(traced.border.figures.facets, 6U);
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

// The facets of quads of a plane or torus model, which come in pairs.
template <class IsIn>
std::vector<TriangleId> facets_of_quads(const TriangleMesh& mesh, IsIn is_in) {
  std::vector<TriangleId> facets;
  for (const TriangleId t : mesh.triangles.ids()) {
    if (is_in(t.index() / 2)) facets.push_back(t);
  }
  return facets;
}

LoopSides sides_of(const TriangleMesh& mesh, const LoopBorder& band,
                   const std::vector<TriangleId>& border) {
  TriangleSet in_border(mesh.triangles.size(), 0);
  for (const TriangleId t : border) in_border[t] = 1;
  return loop_sides(mesh, triangle_neighbors(mesh), band, segment_model(mesh, in_border));
}

// A square of quads around the middle one of 11 x 11, two off it.
constexpr std::size_t side_of_plane = 11;
bool is_in_square(std::size_t quad, std::size_t off) {
  const auto x = static_cast<int>(quad % side_of_plane), y = static_cast<int>(quad / side_of_plane);
  return std::max(std::abs(x - 5), std::abs(y - 5)) == static_cast<int>(off);
}

LoopBorder band_of(const std::vector<TriangleId>& facets) {
  LoopBorder band;
  band.facets = facets;
  return band;
}

struct SquareBand {
  LoopBorder band() const { return band_of(facets); }
  TriangleMesh mesh = testing::grid_plane(side_of_plane);
  std::vector<TriangleId> facets =
      facets_of_quads(mesh, [](std::size_t quad) { return is_in_square(quad, 2); });
};

TEST(LoopSides, AreTheBoundaryCurvesOfTheBandLongestFirst) {
  const SquareBand square;
  LoopBorder band;
  // Some facets are met twice, some by a bridge only.
  for (std::size_t k = 0; k < square.facets.size(); ++k) {
    (k % 5 == 0 ? band.bridges : band.facets).push_back(square.facets[k]);
    if (k % 3 == 0) band.facets.push_back(square.facets[k]);
  }
  const LoopSides found = sides_of(square.mesh, band, square.facets);
  EXPECT_EQ(found.separation, Separation::separates);
  ASSERT_EQ(found.sides.size(), 2U);
  EXPECT_EQ(found.sides[0].edges, 20U);
  EXPECT_EQ(found.sides[0].region, RegionId(0U));
  EXPECT_EQ(found.sides[1].edges, 12U);
  EXPECT_EQ(found.sides[1].region, RegionId(1U));
  band.closed = false;
  EXPECT_EQ(sides_of(square.mesh, band, square.facets).separation, Separation::open_band);
}

// However small a part of the band is, its curve is a side.
TEST(LoopSides, AFacetByItselfHasASide) {
  const SquareBand square;
  LoopBorder band = square.band();
  band.facets.push_back(TriangleId(0U));
  const LoopSides found = sides_of(square.mesh, band, band.facets);
  ASSERT_EQ(found.sides.size(), 3U);
  EXPECT_EQ(found.sides[2].edges, 3U);
  EXPECT_EQ(found.separation, Separation::separates);
}

// Where the band of another loop runs along the outer side, only the inner one borders on a region.
TEST(LoopSides, ASideAlongAnotherBandDoesNotCount) {
  const SquareBand square;
  const LoopBorder band = square.band();
  const std::vector<TriangleId> both = facets_of_quads(
      square.mesh, [](std::size_t quad) { return is_in_square(quad, 2) || is_in_square(quad, 3); });
  const LoopSides found = sides_of(square.mesh, band, both);
  EXPECT_EQ(found.separation, Separation::encloses_nothing);
  ASSERT_EQ(found.sides.size(), 2U);
  EXPECT_TRUE(found.sides[0].region.is_none());
  EXPECT_EQ(found.sides[1].region, RegionId(1U));
  LoopBorder open = band;
  open.closed = false;
  EXPECT_EQ(sides_of(square.mesh, open, both).separation, Separation::open_band);
}

// A wall above and below the square parts what is around it: its outer side borders on both parts.
TEST(LoopSides, ASideIsOfTheRegionThatMostOfItBordersOn) {
  const SquareBand square;
  const LoopBorder band = square.band();
  for (const std::size_t wall : {4U, 5U, 6U}) {
    const std::vector<TriangleId> border = facets_of_quads(square.mesh, [&](std::size_t quad) {
      const std::size_t x = quad % side_of_plane, y = quad / side_of_plane;
      return is_in_square(quad, 2) || (x == wall && (y < 3 || y > 7));
    });
    const LoopSides found = sides_of(square.mesh, band, border);
    ASSERT_EQ(found.sides.size(), 2U);
    // Ties are of the first one.
    EXPECT_EQ(found.sides[0].region, RegionId(wall == 4 ? 1U : 0U)) << wall;
    EXPECT_EQ(found.sides[1].region, RegionId(2U));
  }
}

// The same with a wall right in the middle, and another one that takes two columns from the part on
// the left or right: there are as many edges at either part, but the other one is larger.
TEST(LoopSides, OfRegionsWithAsManyEdgesItIsTheLargerOne) {
  const SquareBand square;
  for (const std::size_t cut : {1U, 9U}) {
    const std::vector<TriangleId> border = facets_of_quads(square.mesh, [&](std::size_t quad) {
      const std::size_t x = quad % side_of_plane, y = quad / side_of_plane;
      return is_in_square(quad, 2) || x == cut || (x == 5 && (y < 3 || y > 7));
    });
    const LoopSides found = sides_of(square.mesh, square.band(), border);
    ASSERT_EQ(found.sides.size(), 2U);
    EXPECT_EQ(found.sides[0].region, RegionId(cut == 1 ? 2U : 0U)) << cut;
  }
}

TEST(LoopSides, OfSidesOfOneLengthThatAtTheLargerRegionIsFirst) {
  const TriangleMesh mesh = testing::torus(60, 24, 0.3);
  const auto ring = [&](std::size_t u) {
    return facets_of_quads(mesh, [u](std::size_t quad) { return quad / 24 == u; });
  };
  std::vector<TriangleId> both = ring(10);
  for (const TriangleId t : ring(50)) both.push_back(t);
  for (const std::size_t u : {10U, 50U}) {
    const LoopSides found = sides_of(mesh, band_of(ring(u)), both);
    ASSERT_EQ(found.sides.size(), 2U);
    for (std::size_t k = 0; k < 2; ++k) {
      EXPECT_EQ(found.sides[k].edges, 24U);
      EXPECT_EQ(found.sides[k].region, RegionId(1 - k));
    }
  }
}

}  // namespace
}  // namespace cocoon
