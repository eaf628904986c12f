#include "update/model/near_facets.h"

#include <gtest/gtest.h>
#include <limits>

#include "geom/random/random.h"
#include "tests/update/hand_made_models.h"

namespace cocoon {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

bool any_facet(TriangleId) { return true; }

// Whatever is within reach is found as by a tree over all facets, at the bound itself, too, and
// whichever facets are asked for.
void expect_answers_of_all_facets(const TriangleMesh& mesh, const std::vector<Point>& centers,
                                  double reach) {
  const ModelIndex index(mesh);
  const NearFacets near(index, centers, reach);
  const NearFacets all(index, centers, infinity);
  for (const Point& p : centers) {
    const ClosestFacet expected = all.closest(p, reach * reach, any_facet);
    EXPECT_EQ(near.closest(p, reach * reach, any_facet), expected);
    const auto odd = [](TriangleId t) { return t.value % 2 == 1; };
    EXPECT_EQ(near.closest(p, reach * reach, odd), all.closest(p, reach * reach, odd));
  }
}

// The same by an index that knows how long the sides are.
void expect_answers_by_sides(const TriangleMesh& mesh, const std::vector<Point>& centers,
                             double reach) {
  const ModelIndex index = ModelIndex::of_smooth(mesh);
  ASSERT_LT(index.longest_extent(), infinity);
  const NearFacets near(index, centers, reach);
  const NearFacets all(index, centers, infinity);
  for (const Point& p : centers) {
    EXPECT_EQ(near.closest(p, reach * reach, any_facet), all.closest(p, reach * reach, any_facet));
  }
}

TEST(NearFacets, AnswerAsAllFacetsDo) {
  Random random(5);
  for (const TriangleMesh& mesh :
       {testing::sphere(4), testing::block(9, 7, 1), testing::torus(40, 12, 0.3)}) {
    for (const double reach : {0.01, 0.3, 2.0, 50.0}) {
      std::vector<Point> centers;
      for (int k = 0; k < 40; ++k) {
        const VertexId v(static_cast<std::size_t>(random.below(mesh.points.size())));
        centers.push_back(mesh.points[v] +
                          random.uniform(0, 1.5 * reach) * random.on_unit_sphere());
      }
      expect_answers_of_all_facets(mesh, centers, reach);
      expect_answers_of_all_facets(mesh, {centers.front()}, reach);
      expect_answers_by_sides(mesh, centers, reach);
      expect_answers_by_sides(mesh, {centers.front()}, reach);
      // No vertex is near, but the middle of a facet.
      const auto& [a, b, c] =
          mesh.triangles[TriangleId(static_cast<std::size_t>(random.below(mesh.triangles.size())))];
      expect_answers_by_sides(mesh, {(mesh.points[a] + mesh.points[b] + mesh.points[c]) / 3},
                              reach);
    }
  }
}

// Ties at edges and vertices, and facets exactly as far away as the reach.
TEST(NearFacets, AnswerAsAllFacetsDoOnAGrid) {
  const TriangleMesh mesh = testing::grid_plane(12);
  std::vector<Point> centers;
  for (int i = -3; i < 16; ++i) centers.push_back({static_cast<double>(i), 4, 2});
  for (const double reach : {0.0, 1.0, 2.0, 3.0})
    expect_answers_of_all_facets(mesh, centers, reach);
}

// A facet without a vertex within reach is there, too.
TEST(NearFacets, HoldsALargeFacetAboveItsMiddle) {
  TriangleMesh mesh;
  for (const Point& p : {Point{-100, -100, 0}, Point{100, -100, 0}, Point{0, 100, 0}}) {
    mesh.points.push_back(p);
  }
  mesh.triangles.push_back({testing::vertex(0), testing::vertex(1), testing::vertex(2)});
  const std::vector<Point> centers = {{0, 0, 1}, {3, 1, 0.5}};
  const NearFacets near(ModelIndex(mesh), centers, 1);
  EXPECT_EQ(near.closest({0, 0, 1}, 1, any_facet).point, (Point{0, 0, 0}));
  EXPECT_TRUE(near.closest({0, 0, 1}, 0.9, any_facet).triangle.is_none());
}

// What is too far away is left out: nothing is found there, whatever the bound.
TEST(NearFacets, LeavesOutWhatIsFarAway) {
  const TriangleMesh mesh = testing::sphere(5);
  const std::vector<Point> centers = {{0, 0, 1}};
  const NearFacets near(ModelIndex(mesh), centers, 0.1);
  EXPECT_TRUE(near.closest({0, 0, -1}, 0.5, any_facet).triangle.is_none());
  EXPECT_FALSE(near.closest({0, 0, 1}, 0.01, any_facet).triangle.is_none());
}

TEST(NearFacets, NothingIsNearNoPlace) {
  const TriangleMesh mesh = testing::sphere(1);
  const NearFacets near(ModelIndex(mesh), {}, 1);
  EXPECT_TRUE(near.closest({1, 0, 0}, 1, any_facet).triangle.is_none());
}

}  // namespace
}  // namespace cocoon
