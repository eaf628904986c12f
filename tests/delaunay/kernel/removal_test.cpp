// Removal where it is hard: on the hull, of nearly everything, in holes that touch, in long
// histories.
#include "delaunay/kernel/removal.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <set>
#include <string>
#include <vector>

#include "delaunay/dynamic_delaunay.h"
#include "geom/errors.h"
#include "geom/random/random.h"
#include "tests/delaunay/dynamic_checks.h"
#include "tests/gallery.h"

namespace cocoon {
namespace {

// A bump on one facet: what fills the hole is one infinite cell, and its three border vertices do
// not span space.
TEST(Removal, RemovesTheApexOfATetrahedronOnAFacet) {
  const std::vector<Point> points{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}, {5, 5, 5}};
  for (std::size_t i = 0; i < points.size(); ++i) {
    DynamicDelaunay dynamic;
    const DelaunayChange inserted = dynamic.insert(points);
    ASSERT_EQ(dynamic.view().cell_records().size(), 8U);  // 2 finite, 6 infinite
    const DelaunayChange change = dynamic.remove(std::vector{inserted.vertex_of_point[i]});
    // The two apexes are first and last; each of the others is in both cells.
    EXPECT_EQ(change.removal.flat_borders, i == 0 || i == 4 ? 1U : 0U);
    EXPECT_EQ(change.created.size(), i == 0 || i == 4 ? 1U : 3U);
    expect_fresh(dynamic);
  }
}

// The star of the center is everything: no finite cell stays.
TEST(Removal, RemovesTheCenterOfASphere) {
  std::vector<Point> points = gallery::integer_sphere(1105);
  points.push_back({0, 0, 0});
  DynamicDelaunay dynamic;
  const DelaunayChange inserted = dynamic.insert(points);
  const DelaunayChange change = dynamic.remove(std::vector{inserted.vertex_of_point.back()});
  EXPECT_EQ(change.removal.holes, 1U);
  EXPECT_EQ(change.removal.border_vertices, points.size() - 1);
  expect_fresh(dynamic);
}

// Holes next to each other: a facet between two deleted cells stays, both of its sides are new.
TEST(Removal, JoinsHolesThatTouch) {
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U}) {
    DynamicDelaunay dynamic;
    dynamic.insert(gallery::uniform_cube(300, seed));
    // A maximal set of vertices no two of which are neighbors.
    std::set<VertexId> removed;
    std::set<VertexId> neighbors;
    const TriangulationView view = dynamic.view();
    for (const VertexId v : live_vertices(dynamic)) {
      if (neighbors.count(v) != 0) continue;
      removed.insert(v);
      for (const Cell& cell : view.cell_records()) {
        if (!cell.vertices[0].is_none() && has_vertex(cell, v)) {
          neighbors.insert(cell.vertices.begin(), cell.vertices.end());
        }
      }
    }
    const DelaunayChange change =
        dynamic.remove(std::vector<VertexId>(removed.begin(), removed.end()));
    EXPECT_EQ(change.removal.holes, removed.size());
    expect_consistent(dynamic);
    expect_fresh(dynamic);
  }
}

TEST(Removal, RemovesAllButFivePoints) {
  for (const auto& points :
       {gallery::uniform_cube(500), gallery::integer_grid(6), gallery::box_faces(3)}) {
    DynamicDelaunay dynamic;
    dynamic.insert(points);
    std::vector<VertexId> live = live_vertices(dynamic);
    Random(2).shuffle(live);
    // Five random ones span space.
    std::vector<VertexId> removed(live.begin() + 5, live.end());
    try {
      dynamic.remove(removed);
      EXPECT_EQ(dynamic.num_vertices(), 5U);
    } catch (const InputError&) {
      ADD_FAILURE() << "five random points are flat";
    }
    expect_fresh(dynamic);
  }
}

TEST(Removal, RemovesAllAndStartsAnew) {
  DynamicDelaunay dynamic;
  dynamic.insert(gallery::uniform_cube(100));
  const DelaunayChange change = dynamic.remove(live_vertices(dynamic));
  EXPECT_EQ(change.removed.size(), 100U);
  EXPECT_TRUE(change.created.empty());
  EXPECT_EQ(dynamic.num_vertices(), 0U);
  EXPECT_EQ(dynamic.freeze().triangulation.num_cells(), 0U);
  EXPECT_EQ(dynamic.insert({}).created.size(), 0U);
  dynamic.insert(gallery::integer_grid(4));
  expect_fresh(dynamic);
}

// Removal first would leave a plane; only the final set counts.
TEST(Removal, ReplacesThePointsThatSpanSpace) {
  DynamicDelaunay dynamic;
  const std::vector<Point> points = gallery::plane_and_apex(6);
  const DelaunayChange inserted = dynamic.insert(points);
  const VertexId apex = inserted.vertex_of_point.back();
  const auto before = cells_by_slot(dynamic);
  const DelaunayChange change =
      dynamic.replace(std::vector{apex}, std::vector<Point>{{1, 1, -3}, {2, 2, 5}});
  expect_journal(before, dynamic, change);
  EXPECT_FALSE(dynamic.contains(apex));
  expect_fresh(dynamic);
  // The apex comes back in the operation that removes it: it stays.
  DynamicDelaunay other;
  other.insert(points);
  const DelaunayChange same = other.replace(std::vector{apex}, std::vector<Point>{points.back()});
  EXPECT_TRUE(same.removed.empty());
  EXPECT_EQ(same.vertex_of_point[0], apex);
  expect_fresh(other);
}

// --- Larger ----------------------------------------------------------------------------------

TEST(Removal, EditsAScan) {
  const std::vector<Point> points =
      gallery::read_xyz(std::string(COCOON_TEST_DATA) + "/poste_france.xyz");
  DynamicDelaunay dynamic(delaunay(points).triangulation);
  Random random(5);
  for (int k = 0; k < 6; ++k) {
    const std::vector<VertexId> removed = patch(dynamic, points[random.below(points.size())], 600);
    std::vector<Point> moved;
    for (const VertexId v : removed) {
      moved.push_back(dynamic.point(v) + 0.01 * random.in_unit_cube());
    }
    dynamic.replace(removed, moved);
    expect_fresh(dynamic);
  }
  expect_consistent(dynamic);
}

// Ten thousand operations on some sixty points of a small grid: full of ties, always near flat.
TEST(Removal, TenThousandOperations) {
  const std::vector<Point> pool = gallery::integer_grid(5);
  Random random(11);
  DynamicDelaunay dynamic;
  dynamic.insert(Points(pool).first(60));
  RemovalCounters removal;
  std::size_t largest = 0;
  for (int step = 0; step < 10000; ++step) {
    const std::vector<VertexId> live = live_vertices(dynamic);
    if (random.below(2) == 0 && live.size() > 20) {
      const DelaunayChange change = dynamic.remove(std::vector{live[random.below(live.size())]});
      removal += change.removal;
      largest = std::max(largest, change.removal.largest_hole);
    } else {
      dynamic.insert(std::vector{pool[random.below(pool.size())]});
    }
    if (step % 50 == 0) expect_fresh(dynamic);
    if (testing::Test::HasFatalFailure()) FAIL() << "in step " << step;
  }
  expect_fresh(dynamic);
  EXPECT_GT(removal.holes, 4000U);
  EXPECT_EQ(removal.largest_hole, largest);
  EXPECT_GT(removal.flat_borders, 5U);
  EXPECT_GT(removal.filling.perturbed_inspheres, 1000U);
}

}  // namespace
}  // namespace cocoon
