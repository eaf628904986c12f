#include "update/cloud/torn_edges.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <vector>

#include "tests/update/hand_made_models.h"

namespace cocoon {
namespace {

// A plane, and a ring on it around a hole of radius 3, with the loop of its inner edge and that of
// its outer one, at radius 6; one unit between samples.
struct RingOnAPlane {
  TriangleMesh plane = testing::grid_plane(20);
  ModelIndex model{plane};
  CloudRim rim;
  std::vector<Point> cloud;

  RingOnAPlane() {
    rim.spacing = rim.median_edge = 1;
    rim.loops = {loop(3, 4), loop(6, 5)};
    for (const double radius : {3.0, 4.0, 5.0, 6.0}) add_ring(radius, 0);
  }
  static Point at(double radius, double turn, double z = 0) {
    return {10 + radius * std::cos(turn), 10 + radius * std::sin(turn), z};
  }
  static RimLoop loop(double radius, double apexes) {
    RimLoop result;
    const int size = static_cast<int>(2 * std::numbers::pi * radius);
    for (int k = 0; k < size; ++k) {
      const double turn = 2 * std::numbers::pi * k / size;
      result.points.push_back(at(radius, turn));
      result.apexes.push_back(at(apexes, turn + std::numbers::pi / size));
    }
    return result;
  }
  void add_ring(double radius, double z) {
    const int size = static_cast<int>(2 * std::numbers::pi * radius);
    for (int k = 0; k < size; ++k) {
      cloud.push_back(at(radius, 2 * std::numbers::pi * (k + 0.5) / size, z));
    }
  }
  std::size_t inner_edges(std::size_t l) const {
    const auto& inner = rim.loops[l].inner;
    return static_cast<std::size_t>(std::count(inner.begin(), inner.end(), 1));
  }
};

TEST(TornEdges, AHoleInTheScanIsARim) {
  RingOnAPlane scene;
  mark_torn_edges(scene.model, {{scene.cloud}}, scene.rim);
  EXPECT_EQ(scene.rim.torn_edges, 0U);
  EXPECT_EQ(scene.inner_edges(0) + scene.inner_edges(1), 0U);
}

// The wall of a hole goes down from its mouth.
TEST(TornEdges, TheMouthOfADrilledHoleIsASeam) {
  RingOnAPlane scene;
  for (const double z : {-0.7, -1.6, -2.5}) scene.add_ring(2.5, z);
  mark_torn_edges(scene.model, {{scene.cloud}}, scene.rim);
  EXPECT_EQ(scene.rim.torn_edges, 18U);
  EXPECT_EQ(scene.rim.seam_edges, 18U);
  EXPECT_TRUE(scene.rim.loops[0].is_seam);
  EXPECT_FALSE(scene.rim.loops[1].is_seam);
  EXPECT_EQ(scene.inner_edges(1), 0U);
}

// The same tear from below: the wall ends a little under the mouth.
TEST(TornEdges, TheUpperEdgeOfAWallIsASeam) {
  RingOnAPlane scene;
  RimLoop& edge = scene.rim.loops[0];
  for (Point& p : edge.points) p.z = -0.7;
  for (std::size_t k = 0; k < edge.size(); ++k) {
    edge.apexes[k] = 0.5 * (edge.points[k] + edge.points[edge.next(k)]) - Vec3{0, 0, 1};
  }
  for (const double z : {-1.6, -2.5}) scene.add_ring(3, z);
  mark_torn_edges(scene.model, {{scene.cloud}}, scene.rim);
  EXPECT_EQ(scene.rim.torn_edges, 18U);
  EXPECT_TRUE(scene.rim.loops[0].is_seam);
  EXPECT_FALSE(scene.rim.loops[1].is_seam);
}

// Half of the loop has cloud beyond it; of the other half, a third is torn.
TEST(TornEdges, AFewAmongOtherSeamsMakeNone) {
  RingOnAPlane scene;
  RimLoop& loop = scene.rim.loops[0];
  loop.inner.assign(loop.size(), 0);
  for (std::size_t k = 0; k < loop.size() / 2; ++k) loop.inner[k] = 1;
  scene.cloud.push_back(RingOnAPlane::at(2.5, 1.5 * std::numbers::pi, -0.7));
  mark_torn_edges(scene.model, {{scene.cloud}}, scene.rim, {.min_torn_share = 0.4});
  EXPECT_FALSE(scene.rim.loops[0].is_seam);
  EXPECT_EQ(scene.rim.torn_edges, 0U);
  mark_torn_edges(scene.model, {{scene.cloud}}, scene.rim, {.min_torn_share = 0.2});
  EXPECT_TRUE(scene.rim.loops[0].is_seam);
}

// Seen by another scan alone.
TEST(TornEdges, AWallOfAnotherCloud) {
  RingOnAPlane scene;
  const std::vector<Point> ring = scene.cloud;
  scene.cloud.clear();
  for (const double z : {-0.7, -1.6, -2.5}) scene.add_ring(2.5, z);
  mark_torn_edges(scene.model, {{ring, scene.cloud}}, scene.rim);
  EXPECT_EQ(scene.rim.torn_edges, 18U);
  EXPECT_TRUE(scene.rim.loops[0].is_seam);
}

// A wall on the side of the scan, as that of a boss, is nothing beyond the rim.
TEST(TornEdges, AWallInsideIsNone) {
  RingOnAPlane scene;
  for (const double z : {0.7, 1.6}) scene.add_ring(5, z);
  mark_torn_edges(scene.model, {{scene.cloud}}, scene.rim);
  EXPECT_EQ(scene.rim.torn_edges, 0U);
}

// A third of the wall: most of the loop is a rim.
TEST(TornEdges, AFewMakeNoSeam) {
  RingOnAPlane scene;
  scene.add_ring(2.5, -0.7);
  std::erase_if(scene.cloud, [](const Point& p) { return p.z < 0 && p.x < 11; });
  mark_torn_edges(scene.model, {{scene.cloud}}, scene.rim);
  EXPECT_EQ(scene.rim.torn_edges, 0U);
  EXPECT_EQ(scene.inner_edges(0), 0U);
  mark_torn_edges(scene.model, {{scene.cloud}}, scene.rim, {.max_seam_share = 0.1});
  EXPECT_GT(scene.rim.torn_edges, 2U);
  EXPECT_LT(scene.rim.torn_edges, 9U);
  EXPECT_EQ(scene.inner_edges(0), 18U);
}

// Torn edges of a loop that is none do not count beside those of a seam.
TEST(TornEdges, AFewBesideASeam) {
  RingOnAPlane scene;
  for (const double z : {-0.7, -1.6, -2.5}) scene.add_ring(2.5, z);
  scene.cloud.push_back(RingOnAPlane::at(6.5, 0.5, 0.7));
  mark_torn_edges(scene.model, {{scene.cloud}}, scene.rim);
  EXPECT_EQ(scene.rim.torn_edges, 18U);
  EXPECT_TRUE(scene.rim.loops[0].is_seam);
  EXPECT_FALSE(scene.rim.loops[1].is_seam);
  EXPECT_EQ(scene.inner_edges(1), 0U);
}

// No rim would be left.
TEST(TornEdges, NotAllOfARimIsASeam) {
  RingOnAPlane scene;
  scene.rim.loops.pop_back();
  scene.add_ring(2.5, -0.7);
  mark_torn_edges(scene.model, {{scene.cloud}}, scene.rim);
  EXPECT_EQ(scene.rim.torn_edges, 0U);
  EXPECT_EQ(scene.inner_edges(0), 0U);
}

// Right over the rim, as noise lies, is not beyond it.
TEST(TornEdges, WhatLiesOverTheRimIsNotBeyondIt) {
  RingOnAPlane scene;
  scene.add_ring(2.98, 0.7);
  mark_torn_edges(scene.model, {{scene.cloud}}, scene.rim);
  EXPECT_EQ(scene.rim.torn_edges, 0U);
  mark_torn_edges(scene.model, {{scene.cloud}}, scene.rim, {.min_outward = 0});
  EXPECT_EQ(scene.rim.torn_edges, 18U);
}

// Nor is a hole whose other side was scanned a little lower, as by a scan out of register.
TEST(TornEdges, ASmallStepIsNone) {
  RingOnAPlane scene;
  scene.add_ring(2.5, -0.3);
  mark_torn_edges(scene.model, {{scene.cloud}}, scene.rim);
  EXPECT_EQ(scene.rim.torn_edges, 0U);
  mark_torn_edges(scene.model, {{scene.cloud}}, scene.rim, {.min_step = 0.2});
  EXPECT_EQ(scene.rim.torn_edges, 18U);
}

// Edges that have cloud beyond them are seams already.
TEST(TornEdges, SeamsAreNotTornOnceMore) {
  RingOnAPlane scene;
  RimLoop& loop = scene.rim.loops[0];
  loop.inner.assign(loop.size(), 0);
  for (std::size_t k = 0; k < 6; ++k) loop.inner[k] = 1;
  for (const double z : {-0.7, -1.6, -2.5}) scene.add_ring(2.5, z);
  mark_torn_edges(scene.model, {{scene.cloud}}, scene.rim);
  EXPECT_TRUE(scene.rim.loops[0].is_seam);
  EXPECT_EQ(scene.rim.torn_edges, 12U);
}

}  // namespace
}  // namespace cocoon
