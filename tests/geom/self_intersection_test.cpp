#include "geom/self_intersection.h"

#include <gtest/gtest.h>
#include <limits>

#include "geom/errors.h"
#include "geom/orient3d.h"
#include "geom/random/random.h"
#include "ref/cgal_mesh_check.h"
#include "tests/mesh_gallery.h"

namespace cocoon {
namespace {

using Corners = std::array<Point, 3>;

constexpr Corners base = {Point{0, 0, 0}, Point{4, 0, 0}, Point{0, 4, 0}};

// Both orders and all rotations must agree.
bool intersect(Corners a, Corners b) {
  const bool result = triangles_intersect(a, b);
  for (int i = 0; i < 3; ++i) {
    std::rotate(a.begin(), a.begin() + 1, a.end());
    for (int j = 0; j < 3; ++j) {
      std::rotate(b.begin(), b.begin() + 1, b.end());
      EXPECT_EQ(triangles_intersect(a, b), result);
      EXPECT_EQ(triangles_intersect(b, a), result);
      EXPECT_EQ(triangles_intersect({a[1], a[0], a[2]}, b), result);
    }
  }
  EXPECT_EQ(ref::cgal_triangles_intersect(a, b), result);
  return result;
}

TEST(TrianglesIntersect, NothingShared) {
  EXPECT_TRUE(intersect(base, {Point{1, 1, -1}, {1, 1, 1}, {9, 9, 1}}));   // pierced
  EXPECT_FALSE(intersect(base, {Point{1, 1, 1}, {2, 1, 1}, {1, 2, 1}}));   // parallel
  EXPECT_FALSE(intersect(base, {Point{5, 5, -1}, {5, 5, 1}, {9, 9, 1}}));  // beside
  EXPECT_TRUE(intersect(base, {Point{1, 1, 0}, {1, 1, 1}, {2, 1, 1}}));    // corner on face
  EXPECT_TRUE(intersect(base, {Point{2, 0, 0}, {2, -1, 1}, {3, -1, 1}}));  // corner on side
  EXPECT_TRUE(intersect(base, {Point{2, 0, -1}, {2, 0, 1}, {2, -3, 0}}));  // side touches side
}

TEST(TrianglesIntersect, NothingSharedInOnePlane) {
  EXPECT_TRUE(intersect(base, {Point{1, 1, 0}, {2, 1, 0}, {1, 2, 0}}));  // inside
  EXPECT_TRUE(intersect(base, {Point{-9, -9, 0}, {30, -9, 0}, {-9, 30, 0}}));
  EXPECT_TRUE(intersect(base, {Point{-1, 1, 0}, {5, 1, 0}, {-1, 2, 0}}));  // across
  EXPECT_FALSE(intersect(base, {Point{5, 0, 0}, {6, 0, 0}, {5, 1, 0}}));   // in line, apart
  EXPECT_TRUE(intersect(base, {Point{1, 0, 0}, {3, 0, 0}, {2, -1, 0}}));   // sides overlap
  EXPECT_TRUE(intersect(base, {Point{2, 2, 0}, {5, 5, 0}, {6, 5, 0}}));    // corner on side
}

TEST(TrianglesIntersect, OneCornerShared) {
  EXPECT_FALSE(intersect(base, {Point{0, 0, 0}, {1, 1, 1}, {2, 1, 1}}));
  EXPECT_TRUE(intersect(base, {Point{0, 0, 0}, {1, 1, 1}, {1, 1, -1}}));    // crosses the face
  EXPECT_TRUE(intersect(base, {Point{0, 0, 0}, {2, 0, 0}, {2, -1, 1}}));    // sides overlap
  EXPECT_TRUE(intersect(base, {Point{0, 0, 0}, {8, 0, 0}, {2, -1, 1}}));    // the longer one
  EXPECT_TRUE(intersect(base, {Point{0, 0, 0}, {9, 9, 0}, {9, 9, 9}}));     // side along face
  EXPECT_FALSE(intersect(base, {Point{0, 0, 0}, {-1, 0, 0}, {0, -1, 0}}));  // in one plane
  EXPECT_TRUE(intersect(base, {Point{0, 0, 0}, {2, 1, 0}, {1, 2, 0}}));     // in one plane
}

TEST(TrianglesIntersect, SideShared) {
  EXPECT_FALSE(intersect(base, {Point{0, 0, 0}, {4, 0, 0}, {0, 0, 3}}));
  EXPECT_FALSE(intersect(base, {Point{0, 0, 0}, {4, 0, 0}, {1, -1, 0}}));  // flat continuation
  EXPECT_TRUE(intersect(base, {Point{0, 0, 0}, {4, 0, 0}, {1, 1, 0}}));    // folded over
  EXPECT_FALSE(intersect(base, {Point{0, 0, 0}, {4, 0, 0}, {1, 1, 0x1p-1000}}));
}

TEST(TrianglesIntersect, SameTriangle) {
  EXPECT_TRUE(intersect(base, base));
  EXPECT_TRUE(intersect(base, {base[1], base[0], base[2]}));
}

TEST(TrianglesIntersect, AgreesWithExactConstructionsOnAGrid) {
  // Corners on a small grid give every degenerate case many times.
  Random random(77);
  int intersecting = 0;
  int tested = 0;
  for (int k = 0; k < 6000; ++k) {
    const std::size_t side = 2 + random.below(3);
    Corners triangles[2];
    for (Corners& t : triangles) {
      for (Point& p : t) {
        const auto coordinate = [&] { return static_cast<double>(random.below(side)); };
        p.x = coordinate();
        p.y = coordinate();
        p.z = coordinate();
      }
    }
    const auto& [a, b] = triangles;
    if (are_collinear(a[0], a[1], a[2]) || are_collinear(b[0], b[1], b[2])) continue;
    ++tested;
    const bool expected = ref::cgal_triangles_intersect(a, b);
    intersecting += expected ? 1 : 0;
    ASSERT_EQ(triangles_intersect(a, b), expected)
        << a[0].x << a[0].y << a[0].z << ' ' << a[1].x << a[1].y << a[1].z << ' ' << a[2].x
        << a[2].y << a[2].z << " against " << b[0].x << b[0].y << b[0].z << ' ' << b[1].x << b[1].y
        << b[1].z << ' ' << b[2].x << b[2].y << b[2].z;
    ASSERT_EQ(triangles_intersect(b, a), expected);
  }
  EXPECT_GT(intersecting, tested / 5);
  EXPECT_GT(tested - intersecting, tested / 5);
}

SelfIntersections by_every_pair(const TriangleMesh& mesh) {
  SelfIntersections result;
  const auto corners = [&mesh](TriangleId t) {
    const Triangle& triangle = mesh.triangles[t];
    return Corners{mesh.points[triangle[0]], mesh.points[triangle[1]], mesh.points[triangle[2]]};
  };
  for (const TriangleId i : mesh.triangles.ids()) {
    for (const TriangleId j : mesh.triangles.ids()) {
      if (i < j && triangles_intersect(corners(i), corners(j))) result.pairs.push_back({i, j});
    }
  }
  result.count = result.pairs.size();
  return result;
}

TEST(SelfIntersection, FindsEveryPairOfASoup) {
  for (const unsigned seed : {1U, 2U, 3U}) {
    const TriangleMesh mesh = gallery::random_soup(250, seed, 0.4);
    const SelfIntersections expected = by_every_pair(mesh);
    const SelfIntersections actual = self_intersection(mesh, {.max_pairs = 100000});
    EXPECT_GT(actual.count, 50U);
    EXPECT_EQ(actual.count, expected.count);
    EXPECT_EQ(actual.pairs, expected.pairs);
    EXPECT_LT(actual.tested_pairs, 250U * 249U / 4);
  }
}

TEST(SelfIntersection, NoneOnProperSurfaces) {
  for (const TriangleMesh& mesh :
       {gallery::cube(), gallery::sphere(3), gallery::torus(15, 9), gallery::open_patch(5, 5),
        gallery::moebius_strip(9), gallery::two_tetrahedra_sharing_an_edge(),
        gallery::two_tetrahedra_sharing_a_vertex()}) {
    const SelfIntersections found = self_intersection(mesh);
    EXPECT_EQ(found.count, 0U);
    EXPECT_EQ(found.intersecting_triangles, 0U);
    EXPECT_GT(found.tested_pairs, 0U);
  }
}

TEST(SelfIntersection, TwoBodiesThroughEachOtherAgreeWithCgal) {
  const TriangleMesh mesh = gallery::join(
      gallery::sphere(3), gallery::translated(gallery::sphere(3), {0.7, 0.123, 0.0456}));
  const SelfIntersections found = self_intersection(mesh);
  const auto expected = ref::cgal_mesh_check(mesh);
  ASSERT_TRUE(expected.has_value());
  EXPECT_GT(found.count, 50U);
  EXPECT_EQ(found.count, expected->self_intersections);
}

TEST(SelfIntersection, SpindleTorusAgreesWithCgal) {
  const TriangleMesh mesh = gallery::torus(24, 24, 0.5, 1.0);  // passes through itself
  const auto expected = ref::cgal_mesh_check(mesh);
  ASSERT_TRUE(expected.has_value());
  EXPECT_GT(expected->self_intersections, 0U);
  EXPECT_EQ(self_intersection(mesh).count, expected->self_intersections);
}

TEST(SelfIntersection, UnweldedCopyHasTheSamePairs) {
  const TriangleMesh mesh = gallery::join(
      gallery::sphere(2), gallery::translated(gallery::sphere(2), {0.7, 0.123, 0.0456}));
  const SelfIntersections expected = self_intersection(mesh);
  EXPECT_GT(expected.count, 0U);
  EXPECT_EQ(self_intersection(gallery::unshared(mesh)), expected);
}

TEST(SelfIntersection, ListsTheFirstPairsAndCountsAll) {
  const TriangleMesh mesh = gallery::random_soup(250, 9, 0.4);
  const SelfIntersections all = self_intersection(mesh, {.max_pairs = 100000});
  const SelfIntersections few = self_intersection(mesh, {.max_pairs = 3});
  EXPECT_EQ(few.count, all.count);
  ASSERT_EQ(few.pairs.size(), 3U);
  EXPECT_TRUE(std::equal(few.pairs.begin(), few.pairs.end(), all.pairs.begin()));
}

TEST(SelfIntersection, SameForAllThreadCountsOrdersScalesAndQuarterTurns) {
  const TriangleMesh mesh = gallery::random_soup(3000, 5, 0.1);
  const SelfIntersections expected = self_intersection(mesh);
  EXPECT_EQ(self_intersection(mesh, {}, {.threads = 4}), expected);
  EXPECT_EQ(self_intersection(gallery::scaled(mesh, 0x1p-200)), expected);
  EXPECT_EQ(self_intersection(gallery::quarter_turned(mesh)).count, expected.count);
  const SelfIntersections shuffled = self_intersection(gallery::shuffled(mesh, 1));
  EXPECT_EQ(shuffled.count, expected.count);
  EXPECT_EQ(shuffled.intersecting_triangles, expected.intersecting_triangles);
  EXPECT_EQ(shuffled.tested_pairs, expected.tested_pairs);
}

TEST(SelfIntersection, TrianglesWithoutAreaAreCountedAndLeftOut) {
  const TriangleMesh mesh =
      gallery::make_mesh({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, -1}, {1, 1, 0}, {1, 1, 1}},
                         {{0, 1, 2}, {3, 4, 5}, {4, 4, 4}});
  const SelfIntersections found = self_intersection(mesh);
  EXPECT_EQ(found.zero_area_triangles, 2U);
  EXPECT_EQ(found.count, 0U);
}

TEST(SelfIntersection, RefusesMissingAndNonFiniteVertices) {
  TriangleMesh mesh = gallery::tetrahedron();
  mesh.points[VertexId(1)].z = std::numeric_limits<double>::infinity();
  EXPECT_THROW(self_intersection(mesh), InputError);
  mesh = gallery::tetrahedron();
  mesh.triangles[TriangleId(0)][0] = VertexId(9);
  EXPECT_THROW(self_intersection(mesh), InputError);
}

}  // namespace
}  // namespace cocoon
