#include "update/rim_angles.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "geom/angles.h"
#include "tests/update/hand_made_models.h"
#include "update/overlapping_facets.h"

namespace cocoon {
namespace {

using std::numbers::pi;

struct Segmented {
  Regions regions;
  RegionAngles angles;
};

Segmented measure(const TriangleMesh& mesh, const CloudRim& rim) {
  const ModelIndex model(mesh);
  const Border border = trace_border(model, rim, overlapping_facets(model, rim));
  Segmented result;
  result.regions = segment_model(mesh, border.facets);
  result.angles = mean_rim_angles(model, result.regions, rim.loops[0], border.loops[0]);
  return result;
}

RegionId region_at(const TriangleMesh& mesh, const Regions& regions, const Point& p) {
  return regions.group_of_vertex[testing::nearest_vertex(mesh, p)];
}

// A cloud whose triangles at the rim rise from a plane at angle a: the region under it is seen at
// a, the one beyond the rim at pi - a.
TEST(MeanRimAngles, TiltOfTheCloud) {
  const TriangleMesh mesh = testing::grid_plane(30);
  for (const double tilt : {0.0, 0.1, 0.7, 1.3}) {
    RimLoop loop = testing::circle(50, {15, 15, 0}, 9);
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Point middle = 0.5 * (loop.points[i] + loop.points[loop.next(i)]);
      const Vec3 inward = unit(loop.apexes[i] - middle);
      loop.apexes[i] = middle + std::cos(tilt) * inward + std::sin(tilt) * Vec3{0, 0, 1};
    }
    const Segmented result = measure(mesh, testing::rim_of({loop}));
    ASSERT_EQ(result.regions.regions.size(), 2U);
    const RegionId inside = region_at(mesh, result.regions, {15, 15, 0});
    const RegionId outside = region_at(mesh, result.regions, {0, 0, 0});
    EXPECT_NEAR(result.angles.regions[inside].mean(), tilt, 1e-9);
    EXPECT_NEAR(result.angles.regions[outside].mean(), pi - tilt, 1e-9);
    EXPECT_EQ(result.angles.regions[inside].edges, 50U);
  }
}

// The literal Eq. 4-5 give pi minus the wedge angle, so that the larger value marks the region to
// be replaced.
TEST(MeanRimAngles, IsPiMinusTheLiteralFormula) {
  const TriangleMesh mesh = testing::sphere(3);
  const ModelIndex model(mesh);
  const CloudRim rim = testing::rim_of({testing::cap_rim(40, unit(Vec3{1, 1, 1}), 0.9)});
  const Border border = trace_border(model, rim, overlapping_facets(model, rim));
  const Regions regions = segment_model(mesh, border.facets);
  const RimLoop& loop = rim.loops[0];
  const RegionAngles angles = mean_rim_angles(model, regions, loop, border.loops[0]);
  ASSERT_EQ(angles.widened, 0U);  // so that the search for P_k below is complete

  for (const RegionId k : regions.regions.ids()) {
    double sum = 0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Point& p0 = loop.points[i];
      const Point& p1 = loop.points[loop.next(i)];
      const Point middle = 0.5 * (p0 + p1);
      VertexId pk;
      for (const TriangleId t : border.loops[0].facets_of(i)) {
        for (const VertexId v : mesh.triangles[t]) {
          if (regions.group_of_vertex[v] != k) continue;
          if (pk.is_none() || squared_distance(mesh.points[v], middle) <
                                  squared_distance(mesh.points[pk], middle)) {
            pk = v;
          }
        }
      }
      if (pk.is_none()) continue;
      sum += pi - literal_dihedral(p0, p1, loop.apexes[i], mesh.points[pk]);
      ++count;
    }
    EXPECT_EQ(angles.regions[k].edges, count);
    EXPECT_NEAR(angles.regions[k].sum, sum, 1e-6);
  }
}

TEST(MeanRimAngles, RegionsAwayFromTheRimDoNotCount) {
  const TriangleMesh mesh = testing::grid_plane(40);
  const ModelIndex model(mesh);
  const CloudRim rim = testing::rim_of({testing::circle(40, {10, 10, 0}, 5),  //
                                        testing::circle(40, {30, 30, 0}, 5)});
  const Border border = trace_border(model, rim, overlapping_facets(model, rim));
  const Regions regions = segment_model(mesh, border.facets);
  ASSERT_EQ(regions.regions.size(), 3U);
  const RegionId other = region_at(mesh, regions, {30, 30, 0});
  const RegionAngles angles = mean_rim_angles(model, regions, rim.loops[0], border.loops[0]);
  EXPECT_EQ(angles.regions[other].edges, 0U);
  EXPECT_GT(angles.regions[region_at(mesh, regions, {10, 10, 0})].edges, 30U);
}

// One edge over the middle of a plane, and regions of a few vertices of it.
struct OneEdge {
  TriangleMesh plane = testing::grid_plane(4);
  Regions regions;
  RimLoop loop;
  LoopBorder band;

  OneEdge(const Point& from, const Point& to, const Point& apex) {
    regions.regions.resize(2);
    regions.group_of_vertex = SparseVector<VertexId, RegionId>(plane.points.size());
    loop.points = {from, to};
    loop.apexes = {apex, apex};
    for (const std::uint32_t t : {20U, 21U}) band.facets.push_back(TriangleId(t));  // of a square
    band.begin = {0, 2, 2};
  }
  static VertexId at(std::size_t x, std::size_t y) { return VertexId(5 * y + x); }
  void put(VertexId v, std::uint32_t region) { regions.group_of_vertex.set(v, RegionId(region)); }
  RegionAngles angles() const { return mean_rim_angles(ModelIndex(plane), regions, loop, band); }
};

// What lies in the ring around may be nearer.
TEST(MeanRimAngles, FacetsUnderTheEdgeComeFirst) {
  OneEdge scene({2.25, 2.125, 0}, {2.75, 2.125, 0}, {2.5, 3, 0});
  scene.band.facets.pop_back();
  scene.band.begin = {0, 1, 1};
  scene.plane.points[OneEdge::at(3, 3)].z = 0.875;
  scene.put(OneEdge::at(3, 3), 0);
  scene.put(OneEdge::at(2, 3), 0);
  scene.put(OneEdge::at(2, 1), 1);
  const RegionAngles angles = scene.angles();
  EXPECT_NEAR(angles.regions[RegionId(0U)].mean(), pi / 4, 1e-12);
  EXPECT_NEAR(angles.regions[RegionId(1U)].mean(), pi, 1e-12);
  EXPECT_EQ(angles.widened, 1U);
  EXPECT_EQ(angles.degenerate, 0U);
}

// Two corners of the square, on both sides of an edge along its diagonal.
TEST(MeanRimAngles, TiesAreDecidedByCoordinates) {
  OneEdge scene({2.25, 2.25, 0}, {2.75, 2.75, 0}, {2, 3, 0});
  scene.put(OneEdge::at(2, 3), 0);
  scene.put(OneEdge::at(3, 2), 0);
  EXPECT_NEAR(scene.angles().regions[RegionId(0U)].mean(), 0, 1e-12);
}

TEST(MeanRimAngles, WhatLiesOnTheLineOfTheEdgeHasNoAngle) {
  OneEdge scene({2.25, 2.25, 0}, {2.75, 2.75, 0}, {2, 3, 0});
  scene.put(OneEdge::at(3, 3), 0);
  scene.put(OneEdge::at(3, 2), 1);
  const RegionAngles angles = scene.angles();
  EXPECT_EQ(angles.regions[RegionId(0U)].edges, 0U);
  EXPECT_EQ(angles.regions[RegionId(1U)].edges, 1U);
  EXPECT_EQ(angles.degenerate, 1U);
  scene.loop.apexes[0] = {4, 4, 0};
  const RegionAngles none = scene.angles();
  EXPECT_EQ(none.regions[RegionId(1U)].edges, 0U);
  EXPECT_EQ(none.degenerate, 1U);
  scene.band = {};
  EXPECT_EQ(scene.angles().degenerate, 0U);
}

}  // namespace
}  // namespace cocoon
