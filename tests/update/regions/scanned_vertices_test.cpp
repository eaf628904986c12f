#include "update/regions/scanned_vertices.h"

#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "tests/update/hand_made_models.h"
#include "update/overlapping_facets.h"
#include "update/trace_border.h"

namespace cocoon {
namespace {

// A plane with vertices on integers, and a rim around the middle, of radius 6.3.
struct Scene {
  TriangleMesh model = testing::grid_plane(20);
  std::vector<CloudRim> rims = {testing::rim_of({testing::circle(60, {10, 10, 0}, 6.3)})};
  std::vector<std::vector<Point>> clouds = {{}};
  RimIndex index = RimIndex(rims);
  Regions regions;

  Scene() {
    const ModelIndex facets(model);
    const Border border = trace_border(facets, rims[0], overlapping_facets(facets, rims[0]));
    regions = segment_model(model, border.facets);
  }
  Scanned at(const Point& p, const ScannedOptions& options = {}) const {
    return scanned_vertices(ModelIndex(model), regions, index, rims, clouds,
                            options)[testing::nearest_vertex(model, p)];
  }
};

constexpr Point near_rim = {15, 14, 0};  // 0.1 outside

TEST(ScannedVertices, ASampleCloseByTells) {
  Scene scene;
  EXPECT_EQ(scene.at(near_rim), Scanned::no);
  scene.clouds[0] = {{10, 10, 0}, {15, 14.7, 0}};
  EXPECT_EQ(scene.at(near_rim), Scanned::no);
  scene.clouds.push_back({{15.1, 14, -0.3}});  // of whatever cloud
  scene.rims.push_back(scene.rims[0]);
  EXPECT_EQ(scene.at(near_rim), Scanned::yes);
}

// The edges at a vertex of the plane are 1 and sqrt(2) long, 1.14 in the mean over its triangles.
TEST(ScannedVertices, TheReachIsAShareOfTheMeanEdge) {
  Scene scene;
  scene.clouds[0] = {near_rim + Vec3{0.5, 0, 0}};
  EXPECT_EQ(scene.at(near_rim, {.sample_reach = 0.5 / 1.13, .depth_weight = 0}), Scanned::yes);
  EXPECT_EQ(scene.at(near_rim, {.sample_reach = 0.5 / 1.15, .depth_weight = 0}), Scanned::no);
}

// Of samples farther apart than the vertices of the model most vertices are far.
TEST(ScannedVertices, TheReachIsAShareOfTheEdgesOfACoarseCloud) {
  Scene scene;
  scene.clouds[0] = {near_rim + Vec3{0.9, 0, 0}};
  EXPECT_EQ(scene.at(near_rim), Scanned::no);
  scene.rims[0].median_edge = 2;
  EXPECT_EQ(scene.at(near_rim), Scanned::yes);
  EXPECT_EQ(scene.at(near_rim, {.cloud_reach = 0.4}), Scanned::no);
  scene.rims.push_back(scene.rims[0]);  // each cloud by its own edges
  scene.rims[0].median_edge = 0.5;
  EXPECT_EQ(scene.at(near_rim), Scanned::no);
  scene.clouds.insert(scene.clouds.begin(), std::vector<Point>());
  EXPECT_EQ(scene.at(near_rim), Scanned::yes);
}

// Where triangles are large no vertex has others close by: samples of a small cloud beside it, far
// away for that cloud, do not replace it.
TEST(ScannedVertices, BeforeTheRimTheReachIsThatOfTheCloud) {
  Scene scene;
  scene.clouds[0] = {near_rim + Vec3{0.3, 0, 0}};
  EXPECT_EQ(scene.at(near_rim), Scanned::yes);
  scene.rims[0].spacing = 0.1;
  EXPECT_EQ(scene.at(near_rim), Scanned::no);
  EXPECT_EQ(scene.at(near_rim, {.outer_reach = 3.1}), Scanned::yes);
  constexpr Point inside = {16, 10, 0};  // by 0.3, where the side of the rim tells
  scene.clouds[0] = {inside + Vec3{0, 0, 0.38}};
  EXPECT_EQ(scene.at(inside), Scanned::yes);
}

// The rim of a coarse cloud is that far from what it samples: its zone is a share of its own edges.
TEST(ScannedVertices, TheZoneOfACoarseRimIsWider) {
  Scene scene;
  constexpr Point farther = {15, 15, 0};  // 0.77 outside; vertices are 1.14 apart in the mean
  EXPECT_EQ(scene.at(farther), Scanned::unclear);
  scene.rims[0].spacing = 3;
  EXPECT_EQ(scene.at(farther), Scanned::no);
}

// A pyramid of four triangles, all of them border, with edges of 2 at its tip and of 2 sqrt(2)
// around: the mean is 2 at the tip, and 2.41 at its neighbors.
TEST(ScannedVertices, TheSpacingAtAVertexIsSmoothedHalfAndHalf) {
  TriangleMesh model;
  for (const Point& p :
       {Point{0, 0, 0}, Point{2, 0, 0}, Point{0, 2, 0}, Point{-2, 0, 0}, Point{0, -2, 0}}) {
    model.points.push_back(p);
  }
  for (std::size_t i = 0; i < 4; ++i) {
    model.triangles.push_back({VertexId(0U), VertexId(1 + i), VertexId(1 + (i + 1) % 4)});
  }
  const ModelIndex facets(model);
  const Regions regions = segment_model(facets, TriangleSet(4, 1));
  const std::vector<CloudRim> rims = {testing::rim_of({testing::circle(12, {5.1, 0, 0}, 5)})};
  const auto at_tip = [&](double distance) {
    const std::vector<std::vector<Point>> clouds = {{{0, 0, distance}}};
    const ScannedOptions options{.sample_reach = 0.5, .cloud_reach = 0, .depth_weight = 0};
    return scanned_vertices(facets, regions, RimIndex(rims), rims, clouds, options)[VertexId(0U)];
  };
  const double spacing = 0.5 * (2 + (2 + 2 * std::sqrt(2)) / 2);
  EXPECT_EQ(at_tip(0.49 * spacing), Scanned::yes);
  EXPECT_EQ(at_tip(0.51 * spacing), Scanned::no);
}

// A sample as far from a vertex on either side of the rim: only the one on the cloud's side has
// been scanned.
TEST(ScannedVertices, TheSideOfTheRimWeighsWithTheSamples) {
  constexpr Point outside = {14, 15, 0};  // by 0.1
  constexpr Point inside = {16, 10, 0};   // by 0.3
  Scene scene;
  for (const double height : {0.38, 0.48}) {
    scene.clouds[0] = {outside + Vec3{0, 0, height}, inside + Vec3{0, 0, height}};
    EXPECT_EQ(scene.at(inside), Scanned::yes) << height;
    EXPECT_EQ(scene.at(outside), Scanned::no) << height;
  }
  const ScannedOptions samples_alone{.depth_weight = 0};
  EXPECT_EQ(scene.at(inside, samples_alone), Scanned::no);
  // Before the rim by so much that no sample is close enough, not even one at the vertex.
  EXPECT_EQ(scene.at(outside, {.depth_weight = 20}), Scanned::no);
  scene.clouds[0] = {outside};
  EXPECT_EQ(scene.at(outside), Scanned::yes);
  EXPECT_EQ(scene.at(outside, {.depth_weight = 20}), Scanned::no);
}

TEST(ScannedVertices, AwayFromTheRimNothingIsSaid) {
  Scene scene;
  scene.clouds[0] = {near_rim, {10, 10, 0}, {10, 17, 0}, {2, 2, 0}};
  for (const Point& p : {Point{10, 10, 0}, Point{10, 17, 0}, Point{2, 2, 0}}) {
    EXPECT_EQ(scene.at(p), Scanned::unclear);
  }
  EXPECT_EQ(scene.at(near_rim, {.rim_zone = 0}), Scanned::unclear);
  EXPECT_EQ(scene.at(near_rim, {.rim_zone = 0.05}), Scanned::unclear);
  EXPECT_EQ(scene.at({10, 17, 0}, {.rim_zone = 0.8}), Scanned::yes);  // the border is that wide
}

// A wall under the plane, as close to the rim as the plane, but not at the border.
TEST(ScannedVertices, OnlyVerticesAtTheBorder) {
  Scene scene;
  const std::size_t first = scene.model.points.size();
  for (const Point& p : {near_rim, Point{15, 15, -4}, Point{16, 14, -4}}) {
    scene.model.points.push_back(p + Vec3{0, 0, -0.05});
    scene.regions.group_of_vertex.push_back(RegionId(0U));
  }
  scene.model.triangles.push_back({VertexId(first), VertexId(first + 1), VertexId(first + 2)});
  scene.regions.region_of_facet.push_back(RegionId(0U));
  scene.clouds[0] = {near_rim};
  const auto scanned = scanned_vertices(ModelIndex(scene.model), scene.regions, scene.index,
                                        scene.rims, scene.clouds);
  EXPECT_EQ(scanned[VertexId(first)], Scanned::unclear);
}

TEST(ScannedVertices, WithoutARimNothingIsSaid) {
  Scene scene;
  scene.clouds[0] = {near_rim};
  scene.index = RimIndex({});
  EXPECT_EQ(scene.at(near_rim), Scanned::unclear);
}

}  // namespace
}  // namespace cocoon
