#include "geom/signed_distance.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "geom/errors.h"
#include "geom/random.h"
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
