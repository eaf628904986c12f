#include "update/trace_border.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <span>
#include <string>
#include <vector>

#include "geom/random/random.h"
#include "geom/search/closest_facet.h"
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
  EXPECT_EQ(border.figures.walks, 6U);
  EXPECT_EQ(border.figures.searches, 0U);
  EXPECT_EQ(border.figures.breaks, 0U);
  EXPECT_GT(border.figures.facets, 6U * 15);
  expect_connected(model, overlap, border);

  // Without tracing regions leak; with it there are two.
  TriangleSet gaps(mesh.triangles.size(), 0);
  for (const TriangleId t : overlap.facets) gaps[t] = 1;
  EXPECT_EQ(segment_model(mesh, gaps).regions.size(), 1U);
  EXPECT_EQ(segment_model(mesh, border.facets).regions.size(), 2U);
}

// Feet exactly on vertices and edges, segments exactly along edges and through vertices.
TEST(TraceBorder, WalksThroughVerticesAndAlongEdges) {
  const TriangleMesh mesh = testing::grid_plane(12);
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
  EXPECT_EQ(border.figures.breaks, 0U);
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
    EXPECT_EQ(border.figures.breaks, 0U) << "round " << round;
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
  EXPECT_EQ(border.figures.searches, 2U);
  EXPECT_EQ(border.figures.breaks, 0U);
  expect_connected(model, overlap, border);

  const Border limited = trace_border(model, rim, overlap, {.max_search_facets = 10});
  EXPECT_EQ(limited.figures.breaks, 2U);
  EXPECT_FALSE(limited.loops[0].closed);
  EXPECT_EQ(limited.figures.facets, 0U);  // nothing of walks that did not arrive
}

// A rim of points that lie on the model, each with the facet next to it towards a place beside it.
struct PlacedRim {
  explicit PlacedRim(const TriangleMesh& mesh) : tree(mesh) { overlap.loops.resize(1); }
  void add(const Point& foot, const Vec3& towards = {}) {
    overlap.loops[0].facets.push_back(tree.closest(foot + towards).triangle);
    overlap.loops[0].feet.push_back(foot);
  }
  Border trace(const ModelIndex& model, const TraceOptions& options = {}) const {
    RimLoop loop;
    loop.points = overlap.loops[0].feet;
    return trace_border(model, {.loops = {loop}}, overlap, options);
  }
  ClosestFacetTree tree;
  Overlap overlap;
};

std::vector<Point> centroids(const ModelIndex& model, std::span<const TriangleId> facets) {
  std::vector<Point> places;
  for (const TriangleId t : facets) places.push_back(model.centroid(t));
  return places;
}

// Along the line y = 2, between rows of facets: a corner on the plane counts as above it, so the
// walks there, which have y < 2 above, cross the row beyond it, and none starts there on the way
// back, which finds all corners above.
TEST(TraceBorder, ACornerOnThePlaneCountsAsAbove) {
  const TriangleMesh mesh = gallery::scaled(testing::grid_plane(16), 0.5);
  const ModelIndex model(mesh);
  PlacedRim rim(mesh);
  for (const double x : {1.2, 4.2, 6.2}) rim.add({x, 2, 0}, {0.1, 0.02, 0});
  const Border border = rim.trace(model);
  EXPECT_EQ(border.figures.walks, 2U);
  EXPECT_EQ(border.figures.searches, 1U);
  for (const Point& p : centroids(model, border.loops[0].facets_of(0))) {
    EXPECT_GT(p.y, 2);
    EXPECT_LT(p.y, 2.5);
  }
}

// Both limits count the facets of a way, its ends among them. On a strip a search looks at no
// other.
TEST(TraceBorder, LimitsCountTheFacetsOfAWay) {
  const TriangleMesh mesh = gallery::scaled(gallery::open_patch(1, 5), 3);
  const ModelIndex model(mesh);
  PlacedRim rim(mesh);
  rim.add({1, 2, 0});     // upper facet of the first quad
  rim.add({14, 1.5, 0});  // lower facet of the fifth
  const std::size_t facets = rim.trace(model).loops[0].facets_of(0).size();
  ASSERT_EQ(facets, 10U);
  EXPECT_EQ(rim.trace(model, {.max_walk_facets = facets}).figures.walks, 2U);
  EXPECT_EQ(rim.trace(model, {.max_walk_facets = facets - 1}).figures.searches, 2U);
  const auto breaks = [&](std::size_t most) {
    return rim.trace(model, {.max_walk_facets = 1, .max_search_facets = most}).figures.breaks;
  };
  EXPECT_EQ(breaks(facets), 0U);
  EXPECT_EQ(breaks(facets - 1), 2U);
}

// From the top of a block to its side, half of the turn to either: straight down from the far end
// of the top would be a longer way.
TEST(TraceBorder, AWalkOverAnEdgeLeansOnBothNormals) {
  const TriangleMesh mesh = gallery::scaled(testing::block(8, 8, 8), 2.5);
  const ModelIndex model(mesh);
  PlacedRim rim(mesh);
  rim.add({12.5, 6.25, 20});
  rim.add({20, 16.25, 12.5});
  const Border border = rim.trace(model);
  EXPECT_EQ(border.figures.walks, 2U);
  std::size_t at_edge = 0;  // y = 11.25 where the way crosses it
  for (const Point& p : centroids(model, border.loops[0].facets_of(0))) {
    if (p.x < 17.5 || p.z < 17.5) continue;
    ++at_edge;
    EXPECT_GT(p.y, 7.5);
    EXPECT_LT(p.y, 15);
  }
  EXPECT_GT(at_edge, 0U);
}

// From the top of a wedge to its bottom: the plane meets it all around, but who passes the end of
// the segment is not on the way there. The short way is around the thin end.
TEST(TraceBorder, AWalkBeyondTheEndOfItsSegmentHasMissed) {
  TriangleMesh mesh = testing::block(12, 6, 1);
  for (Point& p : mesh.points) p = {2 * p.x, 2 * p.y, p.z * (0.5 + 0.25 * p.x)};
  const ModelIndex model(mesh);
  PlacedRim rim(mesh);
  rim.add({4.5, 5.3, 0});
  rim.add({5.1, 5.3, 0.5 + 0.125 * 5.1});
  const Border border = rim.trace(model);
  EXPECT_EQ(border.figures.searches, 2U);
  for (const std::size_t edge : {0U, 1U}) {
    for (const Point& p : centroids(model, border.loops[0].facets_of(edge))) EXPECT_LT(p.x, 8);
  }
}

// What a way costs by the contract of trace_border.
double cost_of_step(const ModelIndex& model, TriangleId from, TriangleId to, const Point& a,
                    const Point& b) {
  const Point center = model.centroid(to);
  const double along = dot(center - a, b - a) / squared_norm(b - a);
  const Point foot = a + std::min(std::max(along, 0.0), 1.0) * (b - a);
  return distance(model.centroid(from), center) + 2 * distance(center, foot);
}

// Of the least cost over all facets, relaxed until nothing changes.
double least_cost(const ModelIndex& model, TriangleId from, TriangleId to, const Point& a,
                  const Point& b) {
  IdVector<TriangleId, double> costs(model.mesh().triangles.size(), 1e300);
  costs[from] = 0;
  for (bool changes = true; changes;) {
    changes = false;
    for (const TriangleId t : costs.ids()) {
      for (const TriangleId next : model.neighbors()[t]) {
        const double cost = costs[t] + cost_of_step(model, t, next, a, b);
        if (cost < costs[next]) {
          costs[next] = cost;
          changes = true;
        }
      }
    }
  }
  return costs[to];
}

// On a rough ring, whose facets are of all sizes.
TEST(TraceBorder, ASearchFindsTheCheapestWay) {
  Random random(31);
  TriangleMesh mesh = gallery::torus(16, 8, 6, 3);
  for (Point& p : mesh.points) p = p + random.on_unit_sphere();
  const ModelIndex model(mesh);
  for (int round = 0; round < 60; ++round) {
    PlacedRim rim(mesh);
    for (int end = 0; end < 2; ++end) {
      rim.add(model.centroid(TriangleId(random.below(mesh.triangles.size()))));
    }
    const Border border = rim.trace(model, {.max_walk_facets = 0});
    const auto facets = border.loops[0].facets_of(0);
    const Point& a = rim.overlap.loops[0].feet[0];
    const Point& b = rim.overlap.loops[0].feet[1];
    if (a == b) continue;
    double cost = 0;
    for (std::size_t k = 0; k + 1 < facets.size(); ++k) {
      cost += cost_of_step(model, facets[k], facets[k + 1], a, b);
    }
    EXPECT_NEAR(cost, least_cost(model, facets.front(), facets.back(), a, b), 1e-9);
  }
}

// A deep way from the left end of the third row to its right one, and a way that is nowhere as far
// from the line through both, but starts away from the other end. What is behind an end is as far
// as that end is.
TEST(TraceBorder, ASearchMeasuresFromTheSegmentNotFromItsLine) {
  constexpr double size = 2.5;
  const std::vector<std::string> rows = {"############", "#..........#", "####....####",
                                         "...#....#...", "...#....#...", "...#....#...",
                                         "...######..."};
  TriangleMesh mesh = testing::grid_plane(12);
  std::vector<Triangle> kept;
  for (const Triangle& t : mesh.triangles) {
    const Point c = (mesh.points[t[0]] + mesh.points[t[1]] + mesh.points[t[2]]) / 3;
    const auto row = static_cast<std::size_t>(c.y);
    if (row < rows.size() && rows[row][static_cast<std::size_t>(c.x)] == '#') kept.push_back(t);
  }
  mesh.triangles = IdVector<TriangleId, Triangle>(kept);
  mesh = gallery::scaled(mesh, size);
  const ModelIndex model(mesh);
  PlacedRim rim(mesh);
  rim.add({3.6 * size, 2.5 * size, 0});
  rim.add({8.4 * size, 2.5 * size, 0});
  const Border border = rim.trace(model);
  EXPECT_EQ(border.figures.searches, 2U);
  for (const std::size_t edge : {0U, 1U}) {
    const auto facets = border.loops[0].facets_of(edge);
    EXPECT_GT(facets.size(), 10U);
    for (const Point& p : centroids(model, facets)) EXPECT_GT(p.y, 2 * size);
  }
}

// Around a hole right in the middle, left and right are as far: the way is that of smaller corners,
// whatever the facets are called.
TEST(TraceBorder, OfTwoWaysOfOneCostThatOfTheSmallerCorners) {
  const TriangleMesh mesh = gallery::make_mesh({{0, 0, 0},
                                                {0, 8, 0},
                                                {-8, 4, 0},
                                                {8, 4, 0},
                                                {-2, 4, 0},
                                                {2, 4, 0},
                                                {-4, -4, 0},
                                                {4, -4, 0},
                                                {-4, 12, 0},
                                                {4, 12, 0}},
                                               {{6, 7, 0},
                                                {6, 0, 2},
                                                {7, 3, 0},
                                                {0, 4, 2},
                                                {0, 3, 5},
                                                {4, 1, 2},
                                                {5, 3, 1},
                                                {2, 1, 8},
                                                {3, 9, 1},
                                                {8, 1, 9}});
  TriangleMesh reversed = mesh;
  std::reverse(reversed.triangles.begin(), reversed.triangles.end());
  for (const TriangleMesh& given : {mesh, reversed}) {
    const ModelIndex model(given);
    PlacedRim rim(given);
    rim.add({0, -3, 0});
    rim.add({0, 11, 0});
    const Border border = rim.trace(model, {.max_walk_facets = 1});
    EXPECT_EQ(border.figures.searches, 2U);
    for (const std::size_t edge : {0U, 1U}) {
      const auto facets = border.loops[0].facets_of(edge);
      ASSERT_EQ(facets.size(), 6U);
      for (std::size_t k = 1; k < 5; ++k) EXPECT_LT(model.centroid(facets[k]).x, 0);
    }
  }
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
  EXPECT_EQ(border.figures.breaks, 2U);
  const Regions regions = segment_model(mesh, border.facets);
  EXPECT_EQ(loop_sides(mesh, model.neighbors(), border.loops[0], regions).separation,
            Separation::open_band);
}

TEST(TraceBorder, WithinOneFacetThereIsNothingToSearch) {
  const TriangleMesh mesh = testing::grid_plane(4);
  const ModelIndex model(mesh);
  const CloudRim rim = rim_of({circle(8, {2.7, 2.3, 0}, 0.2)});
  const Border border = trace_border(model, rim, overlapping_facets(model, rim));
  EXPECT_EQ(border.figures.facets, 1U);
  EXPECT_EQ(border.figures.walks, 8U);
  EXPECT_EQ(border.figures.searches, 0U);
  PlacedRim point(mesh);  // a loop of one point, too, is on a facet
  point.add({2.7, 2.3, 0});
  EXPECT_EQ(point.trace(model).figures.facets, 1U);
}

TEST(TraceBorder, CoveredLoopsAreNoBorder) {
  const TriangleMesh mesh = testing::grid_plane(20);
  const ModelIndex model(mesh);
  const CloudRim rim = rim_of({circle(40, {10, 10, 0}, 6)});
  Overlap overlap = overlapping_facets(model, rim);
  for (const LoopMatch match : {LoopMatch::covered, LoopMatch::off_model}) {
    overlap.loops[0].match = match;
    const Border border = trace_border(model, rim, overlap);
    EXPECT_EQ(border.figures.facets, 0U);
    EXPECT_TRUE(border.loops[0].begin.empty());
  }
}

}  // namespace
}  // namespace cocoon
