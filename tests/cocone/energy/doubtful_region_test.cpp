#include "cocone/energy/doubtful_region.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <vector>

#include "delaunay/delaunay.h"
#include "tests/gallery.h"

namespace cocoon {
namespace {

// Whether the cells are found by the stars of few vertices or in a pass over all.
TEST(DoubtfulRegion, HasTheCellsAtItsVertices) {
  const Triangulation t = delaunay(gallery::bumpy_sphere(5000)).triangulation;
  for (const std::uint32_t every : {1000U, 40U, 2U}) {
    CellMarks marks;
    marks.good = VertexSet(t.num_vertices(), 1);
    std::vector<CellId> cells;
    std::vector<CellId> undecided;
    // Stretches of vertices along the curve, so that there are cells among them.
    for (const VertexId v : t.vertices()) {
      if (v.value % (20 * every) < 20) marks.good[v] = 0;
    }
    for (const CellId c : t.cells()) {
      const auto& vertices = t.cell(c).vertices;
      const auto is_poor = [&](VertexId v) { return v != infinite_vertex && marks.good[v] == 0; };
      if (std::any_of(vertices.begin(), vertices.end(), is_poor)) cells.push_back(c);
      if (std::all_of(vertices.begin(), vertices.end(), is_poor)) undecided.push_back(c);
    }
    ASSERT_FALSE(undecided.empty());
    StarCache stars(t);
    SpacingCache spacings(t, stars);
    const DoubtfulRegion region = find_doubtful_region(t, marks, stars, spacings, t.num_cells(), 0);
    EXPECT_EQ(region.cells, cells);
    EXPECT_EQ(region.undecided, undecided);
    for (std::size_t k = 1; k < region.vertices.size(); ++k) {
      EXPECT_LT(spacings.of(region.vertices[k - 1]), spacings.of(region.vertices[k]));
      EXPECT_TRUE(spacings.precedes(region.vertices[k - 1], region.vertices[k]));
    }
  }
}

// From poor cells and from contradicted vertices, through cells with few good vertices, not beyond.
TEST(DoubtfulRegion, SpreadsThroughThinCells) {
  const Triangulation t = delaunay(gallery::bumpy_sphere(5000)).triangulation;
  CellMarks marks;
  marks.good = VertexSet(t.num_vertices(), 1);
  marks.contradicted = VertexSet(t.num_vertices(), 0);
  marks.conflicts = 1;
  for (const VertexId v : t.vertices()) {
    if (v.value % 800 < 20 || v.value % 9 == 0) marks.good[v] = 0;
    if (v.value % 700 == 1) marks.contradicted[v] = 1;
  }
  StarCache stars(t);
  SpacingCache spacings(t, stars);
  const DoubtfulRegion poor = find_doubtful_region(t, marks, stars, spacings, t.num_cells(), 0);
  for (const int thin_support : {1, 2, 3}) {
    const auto is_thin = [&](CellId c) {
      int good = 0;
      for (const VertexId v : t.cell(c).vertices) good += v != infinite_vertex && marks.good[v];
      return !t.is_infinite(c) && good > 0 && good <= thin_support;
    };
    IdVector<CellId, std::uint8_t> expected(t.num_cells(), 0);
    for (const CellId c : poor.undecided) expected[c] = 1;
    for (const CellId c : t.finite_cells()) {
      for (const VertexId v : t.cell(c).vertices) {
        if (marks.contradicted[v] != 0 && is_thin(c)) expected[c] = 1;
      }
    }
    for (bool changed = true; changed;) {
      changed = false;
      for (const CellId c : t.finite_cells()) {
        for (int i = 0; i < 4; ++i) {
          if (expected[c] != 0 || !is_thin(c) || expected[t.neighbor(c, i)] == 0) continue;
          expected[c] = 1;
          changed = true;
        }
      }
    }
    std::vector<CellId> undecided;
    std::size_t thin = 0;
    for (const CellId c : t.finite_cells()) {
      if (expected[c] != 0) undecided.push_back(c);
      thin += is_thin(c) ? 1U : 0U;
    }
    const DoubtfulRegion region =
        find_doubtful_region(t, marks, stars, spacings, t.num_cells(), thin_support);
    EXPECT_EQ(region.undecided, undecided);
    EXPECT_EQ(region.thin_cells, undecided.size() - poor.undecided.size());
    EXPECT_GT(region.thin_cells, 0U);
    EXPECT_LT(region.thin_cells, thin);
    for (const CellId c : undecided) {
      for (const VertexId v : t.cell(c).vertices) EXPECT_TRUE(region.contains(v));
    }
  }
}

// Where nobody is good, all cells are undecided.
TEST(DoubtfulRegion, LeavesLargeClumpsOnly) {
  std::vector<Point> points = gallery::uniform_cube(300, 1);
  const Triangulation t = delaunay(points).triangulation;
  CellMarks marks;
  marks.good = VertexSet(t.num_vertices(), 0);
  StarCache stars(t);
  SpacingCache spacings(t, stars);
  const std::size_t all = t.num_finite_cells();
  const DoubtfulRegion asked = find_doubtful_region(t, marks, stars, spacings, all, 0);
  EXPECT_EQ(asked.undecided.size(), all);
  EXPECT_EQ(asked.left_cells, 0U);
  EXPECT_EQ(asked.vertices.size(), t.num_vertices());
  const DoubtfulRegion left = find_doubtful_region(t, marks, stars, spacings, all - 1, 0);
  EXPECT_TRUE(left.undecided.empty());
  EXPECT_EQ(left.left_cells, all);
  EXPECT_TRUE(left.vertices.empty());
  EXPECT_TRUE(left.cells.empty());
  // A good vertex every now and then parts the cells.
  for (const VertexId v : t.vertices()) {
    marks.good[v] = t.point(v).x > 0.3 && t.point(v).x < 0.6 ? 1 : 0;
  }
  const DoubtfulRegion small = find_doubtful_region(t, marks, stars, spacings, t.num_cells(), 0);
  const DoubtfulRegion some =
      find_doubtful_region(t, marks, stars, spacings, small.undecided.size() / 2, 0);
  EXPECT_GT(some.left_cells, small.undecided.size() / 2);
  EXPECT_GT(some.undecided.size(), 0U);
  EXPECT_EQ(some.left_cells + some.undecided.size(), small.undecided.size());
  for (const CellId c : some.undecided) {
    for (const VertexId v : t.cell(c).vertices) EXPECT_TRUE(some.contains(v));
  }
}

// As if they had been doubtful from the beginning, but for what is undecided.
TEST(DoubtfulRegion, IsExtendedToWhatItWouldBe) {
  const Triangulation t = delaunay(gallery::bumpy_sphere(2000)).triangulation;
  CellMarks marks;
  marks.good = VertexSet(t.num_vertices(), 1);
  std::vector<VertexId> more;
  for (const VertexId v : t.vertices()) {
    if (v.value % 7 == 0) marks.good[v] = 0;
    if (v.value % 5 == 0) more.push_back(v);
  }
  StarCache stars(t);
  SpacingCache spacings(t, stars);
  DoubtfulRegion extended = find_doubtful_region(t, marks, stars, spacings, t.num_cells(), 0);
  const std::vector<CellId> undecided = extended.undecided;
  more.push_back(more.front());
  std::reverse(more.begin(), more.end());
  extend_region(stars, spacings, more, extended);
  for (const VertexId v : t.vertices()) {
    if (v.value % 5 == 0) marks.good[v] = 0;
  }
  const DoubtfulRegion expected = find_doubtful_region(t, marks, stars, spacings, t.num_cells(), 0);
  EXPECT_EQ(extended.vertices, expected.vertices);
  EXPECT_EQ(extended.cells, expected.cells);
  EXPECT_EQ(extended.undecided, undecided);
  for (const VertexId v : t.vertices()) EXPECT_EQ(extended.rank[v], expected.rank[v]);
}

}  // namespace
}  // namespace cocoon
