#include "geom/signed_distance.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <vector>

#include "geom/errors.h"
#include "geom/random/random.h"
#include "geom/search/closest_facet.h"
#include "tests/mesh_gallery.h"

namespace cocoon {
namespace {

// Of the cube [-1, 1]^3, from its definition.
double distance_from_cube(const Point& p) {
  const Vec3 q{std::abs(p.x) - 1, std::abs(p.y) - 1, std::abs(p.z) - 1};
  const Vec3 beyond{std::max(q.x, 0.0), std::max(q.y, 0.0), std::max(q.z, 0.0)};
  return norm(beyond) + std::min(0.0, std::max({q.x, q.y, q.z}));
}

TriangleMesh cube_around_origin() {
  TriangleMesh cube = gallery::cube();
  for (Point& p : cube.points) p = 2 * p - Vec3{1, 1, 1};
  return cube;
}

TEST(SignedDistance, OfACubeIsThatOfItsDefinition) {
  Random random(7);
  std::vector<Point> points;
  for (int i = 0; i < 2000; ++i) {
    points.push_back({random.uniform(-2, 2), random.uniform(-2, 2), random.uniform(-2, 2)});
  }
  // Closest to a corner, an edge, a facet, from both sides.
  points.insert(points.end(), {{2, 2, 2}, {2, 2, 0}, {2, 0.25, 0.5}, {0.75, 0.25, 0.5}, {1, 1, 1}});
  const std::vector<double> distances = signed_distances(cube_around_origin(), points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_NEAR(distances[i], distance_from_cube(points[i]), 1e-14) << i;
  }
}

// The same bits as those of the search tree, in whatever order a triangle names its corners.
TEST(SignedDistance, IsThatOfTheTreeToTheBit) {
  Random random(8);
  const auto in_cube = [&] { return Point{random.uniform(), random.uniform(), random.uniform()}; };
  for (int i = 0; i < 200; ++i) {
    TriangleMesh mesh;
    for (int k = 0; k < 3; ++k) mesh.points.push_back(in_cube());
    mesh.triangles.push_back({VertexId(2), VertexId(0), VertexId(1)});
    const Point p = in_cube();
    const double distance = std::sqrt(ClosestFacetTree(mesh).squared_distance(p));
    EXPECT_EQ(std::abs(signed_distances(mesh, std::vector<Point>{p})[0]), distance) << i;
  }
}

// The vertex closest to p has one facet that faces away from p, and it may be the one that is
// found.
TEST(SignedDistance, ThinSpikeIsRightBesideItsTip) {
  TriangleMesh spike;
  spike.points = IdVector<VertexId, Point>(
      std::vector<Point>{{-1, -0.1, 0}, {1, -0.1, 0}, {0, 0.1, 0}, {0, 0, 10}});
  const VertexId a(0), b(1), c(2), tip(3);
  spike.triangles = IdVector<TriangleId, Triangle>(
      std::vector<Triangle>{{a, c, b}, {a, b, tip}, {b, c, tip}, {c, a, tip}});
  const std::vector<Point> points = {
      {0.3, 0.3, 10.1}, {-0.3, 0.3, 10.1}, {0, -0.3, 10.1}, {0, 0, 5}};
  const std::vector<double> distances = signed_distances(spike, points);
  EXPECT_GT(distances[0], 0);
  EXPECT_GT(distances[1], 0);
  EXPECT_GT(distances[2], 0);
  EXPECT_LT(distances[3], 0);
}

// Of a spike without a base; on one side of it many triangles meet in the tip, whose normals would
// outweigh the others if angles did not count.
TEST(SignedDistance, ManyNarrowTrianglesDoNotMatter) {
  TriangleMesh spike;
  const VertexId tip = spike.points.push_back({0, 0, 10});
  const VertexId back = spike.points.push_back({0, 0.1, 0});
  std::vector<VertexId> front;
  for (int k = 0; k <= 64; ++k) front.push_back(spike.points.push_back({k / 32.0 - 1, -0.1, 0}));
  for (std::size_t k = 0; k < 64; ++k) spike.triangles.push_back({front[k], front[k + 1], tip});
  spike.triangles.push_back({front.back(), back, tip});
  spike.triangles.push_back({back, front.front(), tip});
  const std::vector<Point> points = {{0, 0.02, 10.1}, {0, -0.02, 10.1}, {0, 0, 9.9}};
  const std::vector<double> distances = signed_distances(spike, points);
  EXPECT_GT(distances[0], 0);
  EXPECT_GT(distances[1], 0);
  EXPECT_LT(distances[2], 0);
}

// An L-shaped prism whose reflex edge has a vertex in the middle, off the edge by a rounding error:
// the sliver between them has a normal that says nothing, and half of the angles at that vertex.
TEST(SignedDistance, SliversOfRoundingErrorsDoNotMatter) {
  constexpr double off = 0x1p-52;
  for (const Vec3 shift : {Vec3{off, -off, 0}, Vec3{-off, off, 0}, Vec3{off, off, 0}}) {
    TriangleMesh mesh;
    const auto add = [&](double x, double y, double z) {
      mesh.points.push_back({x, y, z});
      return VertexId(mesh.points.size() - 1);
    };
    constexpr double outline[6][2] = {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
    std::vector<VertexId> low;
    std::vector<VertexId> high;
    for (const auto& [x, y] : outline) {
      low.push_back(add(x, y, 0));
      high.push_back(add(x, y, 2));
    }
    const VertexId middle = add(1 + shift.x, 1 + shift.y, 1);
    for (std::size_t k = 1; k < 5; ++k) {
      mesh.triangles.push_back({low[0], low[k + 1], low[k]});
      mesh.triangles.push_back({high[0], high[k], high[k + 1]});
    }
    for (std::size_t k = 0; k < 6; ++k) {
      const std::size_t next = (k + 1) % 6;
      mesh.triangles.push_back({low[k], low[next], high[next]});
      if (k != 3) mesh.triangles.push_back({low[k], high[next], high[k]});
    }
    // The half of the wall behind the reflex edge, cut at the vertex; then the sliver.
    mesh.triangles.push_back({low[3], high[4], middle});
    mesh.triangles.push_back({middle, high[4], high[3]});
    mesh.triangles.push_back({low[3], middle, high[3]});
    const std::vector<Point> points = {
        {0.9, 0.9, 1}, {0.8, 0.9, 1}, {0.9, 0.8, 1}, {1.1, 1.1, 1}, {0.5, 0.5, 1}};
    const std::vector<double> distances = signed_distances(mesh, points);
    EXPECT_NEAR(distances[0], -0.1 * std::numbers::sqrt2, 1e-12);
    EXPECT_LT(distances[1], 0);
    EXPECT_LT(distances[2], 0);
    EXPECT_NEAR(distances[3], 0.1, 1e-12);
    EXPECT_NEAR(distances[4], -0.5, 1e-12);
  }
}

TEST(SignedDistance, InsideIsInsideWhicheverWayTheMeshIsTurned) {
  const TriangleMesh cube = gallery::flipped(cube_around_origin());
  EXPECT_EQ(signed_distances(cube, std::vector<Point>{{0, 0, 0.5}, {0, 0, 1.5}}),
            (std::vector<double>{-0.5, 0.5}));
}

// Nothing closed tells: the side of the nearest facet does.
TEST(SignedDistance, OfAnOpenMeshIsThatOfTheNearestFacet) {
  TriangleMesh cube = cube_around_origin();
  cube.triangles.resize(cube.triangles.size() - 1);
  EXPECT_EQ(signed_distances(cube, std::vector<Point>{{0, 0, 0.5}, {0, 0, 1.5}, {0.1, 0, -1.25}}),
            signed_distances(cube_around_origin(),
                             std::vector<Point>{{0, 0, 0.5}, {0, 0, 1.5}, {0.1, 0, -1.25}}));
}

// A tent without floor and ends, steeper than 45 degrees: beside its ridge one of the two facets
// that are nearest has the point behind it.
TEST(SignedDistance, BesideTheRidgeOfAnOpenTentIsOutside) {
  const TriangleMesh tent =
      gallery::make_mesh({{0, 0, 3}, {9, 0, 3}, {0, -1, 0}, {9, -1, 0}, {0, 1, 0}, {9, 1, 0}},
                         {{0, 2, 3}, {0, 3, 1}, {0, 1, 5}, {0, 5, 4}});
  const std::vector<double> distances =
      signed_distances(tent, std::vector<Point>{{4, 0.3, 3.4}, {4, -0.3, 3.4}, {4, 0, 2}});
  EXPECT_NEAR(distances[0], 0.5, 1e-15);
  EXPECT_NEAR(distances[1], 0.5, 1e-15);
  EXPECT_LT(distances[2], 0);
}

// Where squares of areas leave the range of double, and where those of lengths do.
TEST(SignedDistance, CoordinatesOfAnySize) {
  TriangleMesh open = cube_around_origin();
  open.triangles.resize(open.triangles.size() - 1);
  const std::vector<Point> points = {{0, 0, 0.5}, {0.25, 0.5, 1.5}, {0.1, 0, -1.25}, {3, 4, 5}};
  for (const TriangleMesh& mesh : {cube_around_origin(), open}) {
    const std::vector<double> expected = signed_distances(mesh, points);
    for (const double factor : {0x1p-600, 0x1p-270, 0x1p300, 0x1p1000}) {
      std::vector<Point> scaled_points = points;
      for (Point& p : scaled_points) p = factor * p;
      std::vector<double> scaled = expected;
      for (double& distance : scaled) distance *= factor;
      EXPECT_EQ(signed_distances(gallery::scaled(mesh, factor), scaled_points), scaled) << factor;
    }
  }
}

TEST(SignedDistance, ThreadsDoNotMatter) {
  Random random(3);
  std::vector<Point> points;
  for (int i = 0; i < 5000; ++i)
    points.push_back({random.uniform(), random.uniform(), random.uniform()});
  EXPECT_EQ(signed_distances(gallery::cube(), points, {.threads = 1}),
            signed_distances(gallery::cube(), points, {.threads = 4}));
}

TEST(SignedDistance, MeshWithoutTrianglesIsAnError) {
  EXPECT_THROW(signed_distances(TriangleMesh(), std::vector<Point>{{0, 0, 0}}), InputError);
}

}  // namespace
}  // namespace cocoon
