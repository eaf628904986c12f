#include "update/trace_border.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>

#include "geom/closest_facet.h"
#include "geom/random.h"
#include "tests/mesh_gallery.h"
#include "tests/update/hand_made_models.h"
#include "update/regions/loop_sides.h"
#include "update/segment_model.h"

namespace cocoon {
namespace {

using testing::circle;
using testing::rim_of;

bool are_neighbors(const TriangleNeighbors& neighbors, TriangleId a, TriangleId b) {
  const auto& around = neighbors[a];
  return std::find(around.begin(), around.end(), b) != around.end();
}

// Consecutive facets share an edge, from the facet of b_i to that of b_i+1.
void expect_connected(const ModelIndex& model, const Overlap& overlap, const Border& border) {
  for (std::size_t l = 0; l < border.loops.size(); ++l) {
    const LoopOverlap& located = overlap.loops[l];
    const std::size_t n = located.facets.size();
    for (std::size_t i = 0; i < n; ++i) {
      const auto path = border.loops[l].facets_of(i);
      if (located.facets[i].is_none() || located.facets[(i + 1) % n].is_none()) {
        EXPECT_TRUE(path.empty());
        continue;
      }
      ASSERT_FALSE(path.empty()) << "edge " << i;
      EXPECT_EQ(path.front(), located.facets[i]);
      EXPECT_EQ(path.back(), located.facets[(i + 1) % n]);
      for (std::size_t k = 0; k + 1 < path.size(); ++k) {
        EXPECT_TRUE(are_neighbors(model.neighbors(), path[k], path[k + 1]));
      }
      for (const TriangleId t : path) EXPECT_EQ(border.facets[t], 1);
    }
  }
}

TEST(TraceBorder, ClosesTheGapsOfACoarseRim) {
  const TriangleMesh mesh = testing::grid_plane(40);
  const ModelIndex model(mesh);
  const CloudRim rim = rim_of({circle(6, {20, 20, 0.2}, 15)});  // edges of 15 cells
  const Overlap overlap = overlapping_facets(model, rim);
  ASSERT_EQ(overlap.facets.size(), 6U);
  const Border border = trace_border(model, rim, overlap);
  EXPECT_EQ(border.walks, 6U);
  EXPECT_EQ(border.searches, 0U);
  EXPECT_EQ(border.breaks, 0U);
  EXPECT_GT(border.num_facets, 6U * 15);
  expect_connected(model, overlap, border);

  // Without tracing regions leak; with it there are two.
  TriangleSet gaps(mesh.triangles.size(), 0);
  for (const TriangleId t : overlap.facets) gaps[t] = 1;
  EXPECT_EQ(segment_model(mesh, gaps).regions.size(), 1U);
  EXPECT_EQ(segment_model(mesh, border.facets).regions.size(), 2U);
}

// Feet exactly on vertices and edges, segments exactly along edges and through vertices.
TEST(TraceBorder, WalksThroughVerticesAndAlongEdges) {
  const TriangleMesh mesh = testing::grid_plane(10);
  const ModelIndex model(mesh);
  std::vector<Point> square;
  for (const auto& [x, y] :
       std::vector<std::pair<double, double>>{{2, 2}, {5, 2}, {8, 2}, {8, 8}, {5, 5}, {2, 8}}) {
    square.push_back({x, y, 0});
  }
  const CloudRim rim =
      rim_of({testing::loop_towards(square, std::vector<Vec3>(6, Vec3{0, 0, 1}), {5, 3, 0})});
  const Overlap overlap = overlapping_facets(model, rim);
  const Border border = trace_border(model, rim, overlap);
  expect_connected(model, overlap, border);
  EXPECT_EQ(border.breaks, 0U);
  EXPECT_EQ(segment_model(mesh, border.facets, {.min_region_facets = 1}).regions.size(), 2U);
}

// Property: whatever the sizes, a cap's rim cuts the sphere into inside and outside.
TEST(TraceBorder, RandomCapsAlwaysSeparate) {
  const TriangleMesh mesh = testing::sphere(4);
  const ModelIndex model(mesh);
  Random random(23);
  for (int round = 0; round < 40; ++round) {
    const std::size_t n = 5 + random.below(120);
    RimLoop loop = testing::cap_rim(n, random.on_unit_sphere(), random.uniform(0.35, 2.4));
    for (Point& p : loop.points) p = (1 + random.uniform(-0.01, 0.01)) * p;
    const CloudRim rim = rim_of({loop});
    const Overlap overlap = overlapping_facets(model, rim);
    ASSERT_EQ(overlap.status, OverlapStatus::ok);
    const Border border = trace_border(model, rim, overlap);
    EXPECT_EQ(border.breaks, 0U) << "round " << round;
    expect_connected(model, overlap, border);
    const Regions regions = segment_model(mesh, border.facets);
    EXPECT_EQ(regions.regions.size(), 2U) << "round " << round << ", " << n << " points";
    EXPECT_EQ(loop_sides(mesh, model.neighbors(), border.loops[0], regions).separation,
              Separation::separates);
  }
}

using Corners = std::array<Point, 3>;
std::vector<Corners> band_of(const TriangleMesh& mesh, const CloudRim& rim) {
  const ModelIndex model(mesh);
  const Border border = trace_border(model, rim, overlapping_facets(model, rim));
  std::vector<Corners> band;
  for (const TriangleId t : mesh.triangles.ids()) {
    if (border.facets[t] != 0) band.push_back(sorted_corners(corners_of(mesh, t)));
  }
  std::sort(band.begin(), band.end());
  return band;
}

// Feet on vertices and edges, where roundings decide: of rims above a rough ball, and of searches
// over a block with many equal ways.
TEST(TraceBorder, DoesNotDependOnTheOrderOfTheModel) {
  Random random(29);
  TriangleMesh ball = testing::sphere(4);
  for (Point& p : ball.points) p = random.uniform(0.9, 1.1) * p;
  const TriangleMesh cube = testing::block(8, 8, 8);
  for (std::uint64_t round = 0; round < 60; ++round) {
    SCOPED_TRACE(round);
    RimLoop loop = testing::cap_rim(5 + random.below(40), random.on_unit_sphere(), 1);
    for (Point& p : loop.points) p = random.uniform(1.1, 1.15) * p;
    const CloudRim around_ball = rim_of({loop});
    for (Point& p : loop.points) p = Point{4, 4, 4} + 5.6 * p;
    const CloudRim around_cube = rim_of({loop});
    const auto seed = static_cast<unsigned>(round);
    EXPECT_EQ(band_of(gallery::shuffled(ball, seed), around_ball), band_of(ball, around_ball));
    EXPECT_EQ(band_of(gallery::shuffled(cube, seed), around_cube), band_of(cube, around_cube));
  }
}

TEST(TraceBorder, UnmatchedStretchIsBridged) {
  const TriangleMesh mesh = testing::grid_plane(40);
  const ModelIndex model(mesh);
  RimLoop loop = circle(60, {20, 20, 0}, 12);
  for (std::size_t i = 10; i < 14; ++i) loop.points[i].z = 30;
  const CloudRim rim = rim_of({loop});
  const Overlap overlap = overlapping_facets(model, rim);
  ASSERT_EQ(overlap.unmatched, 4U);
  ASSERT_EQ(overlap.status, OverlapStatus::ok);
  const Border border = trace_border(model, rim, overlap);
  expect_connected(model, overlap, border);
  EXPECT_FALSE(border.loops[0].bridges.empty());
  EXPECT_TRUE(border.loops[0].closed);
  EXPECT_EQ(segment_model(mesh, border.facets).regions.size(), 2U);
}

// Around a sharp edge the cutting plane of a long rim edge leaves the model: the search takes over.
TEST(TraceBorder, SearchesAroundWhereTheWalkFails) {
  const TriangleMesh mesh = testing::block(10, 10, 10);
  const ModelIndex model(mesh);
  const ClosestFacetTree tree(mesh);
  Overlap overlap;  // from the middle of the top to the middle of the bottom and back
  overlap.loops.resize(1);
  for (const Point& p : {Point{5.2, 5.1, 10}, Point{5.3, 4.8, 0}}) {
    overlap.loops[0].facets.push_back(tree.closest(p).triangle);
    overlap.loops[0].feet.push_back(p);
  }
  RimLoop loop;
  loop.points = overlap.loops[0].feet;
  const CloudRim rim{.loops = {loop}};
  const Border border = trace_border(model, rim, overlap);
  EXPECT_EQ(border.searches, 2U);
  EXPECT_EQ(border.breaks, 0U);
  expect_connected(model, overlap, border);

  const Border limited = trace_border(model, rim, overlap, {.max_search_facets = 10});
  EXPECT_EQ(limited.breaks, 2U);
  EXPECT_FALSE(limited.loops[0].closed);
  EXPECT_EQ(limited.num_facets, 0U);  // nothing of walks that did not arrive
}

TEST(TraceBorder, NoWayBetweenSeparateBodies) {
  TriangleMesh mesh = testing::block(3, 3, 3);
  const std::size_t vertices = mesh.points.size();
  const TriangleMesh other = testing::block(3, 3, 3);
  for (const Point& p : other.points) mesh.points.push_back(p + Vec3{4, 0, 0});
  for (Triangle t : other.triangles) {
    for (VertexId& v : t) v = VertexId(v.index() + vertices);
    mesh.triangles.push_back(t);
  }
  const ModelIndex model(mesh);
  const CloudRim rim = rim_of({circle(24, {3.5, 1.5, 3}, 1.2)});
  const Overlap overlap = overlapping_facets(model, rim);
  const Border border = trace_border(model, rim, overlap);
  EXPECT_EQ(border.breaks, 2U);
  const Regions regions = segment_model(mesh, border.facets);
  EXPECT_EQ(loop_sides(mesh, model.neighbors(), border.loops[0], regions).separation,
            Separation::open_band);
}

TEST(TraceBorder, WithinOneFacetThereIsNothingToSearch) {
  const TriangleMesh mesh = testing::grid_plane(4);
  const ModelIndex model(mesh);
  const CloudRim rim = rim_of({circle(8, {2.7, 2.3, 0}, 0.2)});
  const Border border = trace_border(model, rim, overlapping_facets(model, rim));
  EXPECT_EQ(border.num_facets, 1U);
  EXPECT_EQ(border.walks, 8U);
  EXPECT_EQ(border.searches, 0U);
}

TEST(TraceBorder, CoveredLoopsAreNoBorder) {
  const TriangleMesh mesh = testing::grid_plane(20);
  const ModelIndex model(mesh);
  const CloudRim rim = rim_of({circle(40, {10, 10, 0}, 6)});
  Overlap overlap = overlapping_facets(model, rim);
  for (const LoopMatch match : {LoopMatch::covered, LoopMatch::off_model}) {
    overlap.loops[0].match = match;
    const Border border = trace_border(model, rim, overlap);
    EXPECT_EQ(border.num_facets, 0U);
    EXPECT_TRUE(border.loops[0].begin.empty());
  }
}

}  // namespace
}  // namespace cocoon
