#include "update/model/orient_outward.h"

#include <gtest/gtest.h>
#include <utility>

#include "geom/mesh_check.h"
#include "geom/mesh_measure.h"
#include "geom/random/random.h"
#include "tests/mesh_gallery.h"

namespace cocoon {
namespace {

using gallery::cube;
using gallery::flipped;
using gallery::join;
using gallery::translated;

TriangleMesh turned_at_random(TriangleMesh mesh, double share, std::uint64_t seed) {
  Random random(seed);
  for (Triangle& t : mesh.triangles) {
    if (random.uniform() < share) std::swap(t[1], t[2]);
  }
  return mesh;
}

TriangleMesh without_first(const TriangleMesh& mesh, std::size_t count) {
  TriangleMesh result{mesh.points, {}};
  for (const TriangleId t : mesh.triangles.ids()) {
    if (t.index() >= count) result.triangles.push_back(mesh.triangles[t]);
  }
  return result;
}

const TriangleMesh hollow = join(cube(3), flipped(translated(cube(1), {1, 1, 1})));

TEST(OrientOutward, WhatFacesOutwardStays) {
  for (const TriangleMesh& mesh :
       {cube(), gallery::torus(20, 8), hollow, without_first(gallery::sphere(3), 5),
        gallery::open_patch(4, 4), flipped(gallery::open_patch(4, 4)), TriangleMesh{}}) {
    TriangleMesh oriented = mesh;
    EXPECT_EQ(orient_outward(oriented).turned, 0U);
    EXPECT_EQ(oriented.triangles, mesh.triangles);
  }
}

TEST(OrientOutward, WhatFacesInwardIsTurned) {
  for (const TriangleMesh& mesh :
       {cube(), gallery::torus(20, 8), hollow, without_first(gallery::sphere(3), 5),
        join(cube(), translated(cube(2), {5, 0, 0}))}) {
    TriangleMesh oriented = flipped(mesh);
    EXPECT_EQ(orient_outward(oriented).turned, mesh.triangles.size());
    EXPECT_TRUE(mesh_check(oriented).oriented);
    EXPECT_EQ(mesh_measure(oriented).signed_volume, mesh_measure(mesh).signed_volume);
  }
}

// A ball of radius 4 that lacks a cap, a hundred and more radii from the origin, as in coordinates
// of a survey. The first triangles are not at the hole.
TEST(OrientOutward, OpenBodiesFarFromTheOriginToo) {
  const TriangleMesh ball = gallery::scaled(gallery::sphere(3), 4);
  for (const Vec3& to :
       {Vec3{}, Vec3{2000, 0, 0}, Vec3{-2000, 0, 0}, Vec3{0, 0, 2e6}, Vec3{0, 0, -2e6}}) {
    const TriangleMesh moved = translated(ball, to);
    for (const Vec3& hole : {Vec3{1, 0, 0}, Vec3{-1, 0, 0}, Vec3{0, 0, 1}, Vec3{0, 0, -1}}) {
      TriangleMesh mesh{moved.points, {}};
      for (const TriangleId t : ball.triangles.ids()) {
        const auto [a, b, c] = corners_of(ball, t);
        if (dot(a + b + c, hole) < 3 * 3.5) mesh.triangles.push_back(ball.triangles[t]);
      }
      ASSERT_LT(mesh.triangles.size(), ball.triangles.size());
      TriangleMesh outward = mesh;
      EXPECT_EQ(orient_outward(outward).turned, 0U);
      TriangleMesh inward = flipped(mesh);
      EXPECT_EQ(orient_outward(inward).turned, mesh.triangles.size());
    }
  }
}

// Whatever share was turned: one of the two ways is outward, and no vote can tell which.
TEST(OrientOutward, TrianglesAtOddsAgree) {
  const TriangleMesh mesh = join(gallery::sphere(3), translated(gallery::torus(20, 8), {9, 0, 0}));
  for (const double share : {0.01, 0.3, 0.5, 0.9}) {
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
      TriangleMesh oriented = turned_at_random(mesh, share, seed);
      EXPECT_GT(orient_outward(oriented).turned, 0U);
      EXPECT_TRUE(mesh_check(oriented).is_closed_manifold());
      EXPECT_DOUBLE_EQ(mesh_measure(oriented).signed_volume, mesh_measure(mesh).signed_volume);
    }
  }
}

// The box agrees by most of its triangles, which face inward; once it is turned, its volume holds
// that of the hollow within it, which is as it should be.
TEST(OrientOutward, HollowsOfABodyAtOddsStay) {
  const TriangleMesh mesh =
      join(gallery::scaled(cube(), 6), flipped(translated(cube(2), {2, 2, 2})));
  TriangleMesh oriented = mesh;
  for (std::size_t i = 0; i < 8; ++i) {
    Triangle& t = oriented.triangles[TriangleId(i)];
    std::swap(t[1], t[2]);
  }
  EXPECT_EQ(orient_outward(oriented).turned, 8U);
  EXPECT_EQ(oriented.triangles, mesh.triangles);
}

// A sheet at odds agrees in the end, but the side that most triangles showed stays.
TEST(OrientOutward, SheetsKeepTheirSide) {
  for (const TriangleMesh& patch :
       {gallery::open_patch(6, 6), flipped(gallery::open_patch(6, 6))}) {
    TriangleMesh oriented = patch;
    std::swap(oriented.triangles[TriangleId(7)][1], oriented.triangles[TriangleId(7)][2]);
    EXPECT_EQ(orient_outward(oriented).turned, 1U);
    EXPECT_EQ(oriented.triangles, patch.triangles);
  }
}

// The cone from its open edges has a volume, whose sign says nothing: a dish is no body.
TEST(OrientOutward, CurvedSheetsKeepTheirSideToo) {
  for (const double height : {0.1, -0.1}) {
    TriangleMesh dish = gallery::open_patch(6, 6);
    for (Point& p : dish.points) {
      p.z = height * ((p.x - 3) * (p.x - 3) + (p.y - 3) * (p.y - 3));
    }
    for (const TriangleMesh& patch : {dish, flipped(dish)}) {
      TriangleMesh oriented = patch;
      EXPECT_EQ(orient_outward(oriented).turned, 0U);
      std::swap(oriented.triangles[TriangleId(7)][1], oriented.triangles[TriangleId(7)][2]);
      EXPECT_EQ(orient_outward(oriented).turned, 1U);
      EXPECT_EQ(oriented.triangles, patch.triangles);
    }
  }
}

TEST(OrientOutward, OneSidedPartsStay) {
  const TriangleMesh strip = translated(gallery::moebius_strip(30), {9, 0, 0});
  TriangleMesh mesh = join(flipped(cube()), strip);
  const OutwardReport report = orient_outward(mesh);
  EXPECT_EQ(report.turned, 12U);
  EXPECT_EQ(report.one_sided, 1U);
  EXPECT_EQ(mesh.triangles, join(cube(), strip).triangles);
  // Closed ones have no sign of a volume, either.
  for (const TriangleMesh& closed :
       {gallery::projective_plane(), flipped(gallery::projective_plane())}) {
    TriangleMesh plane = closed;
    const OutwardReport found = orient_outward(plane);
    EXPECT_EQ(found.one_sided, 1U);
    EXPECT_EQ(found.turned, 0U);
    EXPECT_EQ(plane.triangles, closed.triangles);
  }
}

}  // namespace
}  // namespace cocoon
