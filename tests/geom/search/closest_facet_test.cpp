#include "geom/search/closest_facet.h"

#include <cmath>
#include <cstdint>
#include <gtest/gtest.h>
#include <limits>

#include "geom/errors.h"
#include "geom/random/random.h"
#include "ref/brute_force_closest_facet.h"
#include "tests/mesh_gallery.h"
#include "tests/random_point.h"

namespace cocoon {
namespace {

using gallery::make_mesh;

TEST(ClosestFacet, AboveBesideAndBeyondOneTriangle) {
  const ClosestFacetTree tree(make_mesh({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, {{0, 1, 2}}));
  EXPECT_EQ(tree.closest({1, 1, 3}), (ClosestFacet{TriangleId(0), {1, 1, 0}, 9}));
  EXPECT_EQ(tree.closest({1, -2, 0}), (ClosestFacet{TriangleId(0), {1, 0, 0}, 4}));
  EXPECT_EQ(tree.closest({-3, -4, 0}), (ClosestFacet{TriangleId(0), {0, 0, 0}, 25}));
  EXPECT_EQ(tree.closest({3, 3, 0}), (ClosestFacet{TriangleId(0), {2, 2, 0}, 2}));
}

TEST(ClosestFacet, AgreesWithLookingAtEveryTriangle) {
  Random random(11);
  for (const TriangleMesh& mesh :
       {gallery::random_soup(300, 1, 0.2), gallery::random_soup(50, 2, 1.0), gallery::sphere(3),
        gallery::torus(20, 9), gallery::cube()}) {
    const ClosestFacetTree tree(mesh);
    for (int k = 0; k < 300; ++k) {
      const Point p = random_point(random, -1.5, 2.5);
      const ClosestFacet actual = tree.closest(p);
      const ClosestFacet expected = ref::brute_force_closest_facet(mesh, p);
      ASSERT_NEAR(std::sqrt(actual.squared_distance), std::sqrt(expected.squared_distance), 1e-14)
          << p.x << " " << p.y << " " << p.z;
      ASSERT_EQ(actual.squared_distance, squared_distance(p, actual.point));
      ASSERT_EQ(actual.squared_distance, tree.squared_distance(p));
      ASSERT_TRUE(tree.is_within(p, actual.squared_distance));
      ASSERT_TRUE(tree.is_within(p, 1.5 * actual.squared_distance));
      ASSERT_FALSE(tree.is_within(p, 0.999999 * actual.squared_distance));
      ASSERT_LE(distance(actual.point, expected.point), 1e-7);
    }
  }
}

TEST(ClosestFacet, ManyQueriesAndWhereTheSearchBeginsChangeNothing) {
  Random random(13);
  for (const TriangleMesh& mesh :
       {gallery::random_soup(300, 1, 0.2), gallery::sphere(3), gallery::open_patch(6, 6)}) {
    const ClosestFacetTree tree(mesh);
    const ClosestFacetTree prepared(mesh, {}, 100000);
    std::uint32_t slot = 0;
    for (int k = 0; k < 2000; ++k) {
      // Grid points are equally far from many triangles.
      Point p = random_point(random, -1.5, 2.5);
      if (k % 2 == 0) p = {std::round(2 * p.x) / 2, std::round(2 * p.y) / 2, std::round(p.z)};
      const ClosestFacet expected = tree.closest(p);
      ASSERT_EQ(prepared.closest(p), expected);
      ASSERT_EQ(prepared.closest(p, slot), expected);
    }
  }
}

TEST(ClosestFacet, PointsOfTheSurfaceAreAtDistanceZero) {
  const TriangleMesh mesh = gallery::torus(12, 7);
  const ClosestFacetTree tree(mesh);
  for (const VertexId v : mesh.points.ids()) {
    EXPECT_EQ(tree.closest(mesh.points[v]).squared_distance, 0);
    EXPECT_EQ(tree.closest(mesh.points[v]).point, mesh.points[v]);
  }
}

// The corners of the winner, which name it whatever its id.
std::array<Point, 3> corners(const TriangleMesh& mesh, TriangleId t) {
  std::array<Point, 3> points;
  for (std::size_t i = 0; i < 3; ++i) points[i] = mesh.points[mesh.triangles[t][i]];
  std::sort(points.begin(), points.end(),
            [](const Point& a, const Point& b) { return (a <=> b) < 0; });
  return points;
}

TEST(ClosestFacet, TiesAreDecidedByCoordinatesWhateverTheOrder) {
  Random random(5);
  for (const TriangleMesh& mesh :
       {gallery::cube(), gallery::open_patch(4, 4), gallery::sphere(2), gallery::torus(9, 6)}) {
    const ClosestFacetTree tree(mesh);
    for (const unsigned seed : {1U, 2U, 3U}) {
      const TriangleMesh other = gallery::shuffled(mesh, seed);
      const ClosestFacetTree other_tree(other);
      for (int k = 0; k < 100; ++k) {
        // Grid points are equally far from many triangles.
        const auto grid = [&random] { return static_cast<double>(random.below(9)) / 2 - 1; };
        const double x = grid();
        const double y = grid();
        const Point p = {x, y, grid()};
        const ClosestFacet a = tree.closest(p);
        const ClosestFacet b = other_tree.closest(p);
        ASSERT_EQ(a.point, b.point);
        ASSERT_EQ(a.squared_distance, b.squared_distance);
        ASSERT_EQ(corners(mesh, a.triangle), corners(other, b.triangle));
      }
    }
  }
}

TEST(ClosestFacet, EqualTrianglesGiveTheSmallestId) {
  const TriangleMesh mesh =
      make_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {1, 2, 0}, {2, 1, 0}});
  EXPECT_EQ(ClosestFacetTree(mesh).closest({5, 5, 5}).triangle, TriangleId(0));
}

TEST(ClosestFacet, ScalesExactlyByPowersOfTwo) {
  const TriangleMesh mesh = gallery::torus(12, 7);
  Random random(3);
  for (const double factor : {0x1p-60, 0x1p40}) {
    const ClosestFacetTree tree(mesh);
    const ClosestFacetTree scaled_tree(gallery::scaled(mesh, factor));
    for (int k = 0; k < 100; ++k) {
      const Point p = random_point(random, -3, 3);
      const ClosestFacet a = tree.closest(p);
      const ClosestFacet b = scaled_tree.closest(factor * p);
      EXPECT_EQ(a.triangle, b.triangle);
      EXPECT_EQ(factor * a.point, b.point);
      EXPECT_EQ(factor * factor * a.squared_distance, b.squared_distance);
    }
  }
}

TEST(ClosestFacet, DegenerateTrianglesAreSegmentsAndPoints) {
  const ClosestFacetTree segment(make_mesh({{0, 0, 0}, {1, 0, 0}, {3, 0, 0}}, {{0, 2, 1}}));
  EXPECT_EQ(segment.closest({2, 1, 0}).point, (Point{2, 0, 0}));
  EXPECT_EQ(segment.closest({5, 0, 0}).point, (Point{3, 0, 0}));
  const ClosestFacetTree point(make_mesh({{1, 1, 1}}, {{0, 0, 0}}));
  EXPECT_EQ(point.closest({1, 1, 3}), (ClosestFacet{TriangleId(0), {1, 1, 1}, 4}));
}

TEST(ClosestFacet, RefusesMeshesItCannotSearch) {
  EXPECT_THROW(ClosestFacetTree(TriangleMesh{}), InputError);
  TriangleMesh mesh = gallery::tetrahedron();
  mesh.points[VertexId(1)].z = std::numeric_limits<double>::infinity();
  EXPECT_THROW(ClosestFacetTree{mesh}, InputError);
  mesh = gallery::tetrahedron();
  mesh.triangles[TriangleId(0)][0] = VertexId(9);
  EXPECT_THROW(ClosestFacetTree{mesh}, InputError);
}

}  // namespace
}  // namespace cocoon
