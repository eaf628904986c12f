#include "cocone/side_split.h"

#include <gtest/gtest.h>
#include <set>

#include "cocone/doubtful_region.h"
#include "delaunay/delaunay.h"
#include "tests/cocone/sample_shapes.h"
#include "tests/gallery.h"

namespace cocoon {
namespace {

// The cells next to `cells` on their side must be in one part of it without them.
bool falls_apart(const Triangulation& t, const IdVector<CellId, std::uint8_t>& out,
                 const std::set<CellId>& cells) {
  const std::uint8_t side = out[*cells.begin()];
  std::set<CellId> around;
  for (const CellId c : cells) {
    for (int i = 0; i < 4; ++i) {
      const CellId behind = t.neighbor(c, i);
      if (out[behind] == side && !cells.contains(behind)) around.insert(behind);
    }
  }
  if (around.empty()) return false;
  std::set<CellId> reached{*around.begin()};
  std::vector<CellId> stack{*around.begin()};
  while (!stack.empty()) {
    const CellId c = stack.back();
    stack.pop_back();
    for (int i = 0; i < 4; ++i) {
      const CellId behind = t.neighbor(c, i);
      if (out[behind] != side || cells.contains(behind)) continue;
      if (reached.insert(behind).second) stack.push_back(behind);
    }
  }
  for (const CellId c : around) {
    if (!reached.contains(c)) return true;
  }
  return false;
}

TEST(SideSplit, SaysWhatAPlainSearchSays) {
  std::size_t apart = 0;
  std::size_t together = 0;
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const Triangulation t = delaunay(gallery::uniform_cube(150, seed)).triangulation;
    Random random(seed);
    IdVector<CellId, std::uint8_t> out(t.num_cells(), 1);
    for (const CellId c : t.finite_cells()) out[c] = random.uniform() < 0.4 ? 1 : 0;
    SideSplit side_split(t, out);
    for (int round = 0; round < 500; ++round) {
      CellId c(
          static_cast<std::size_t>(random.uniform() * static_cast<double>(t.num_finite_cells())));
      std::set<CellId> cells{c};
      for (int step = 0; step < round % 5; ++step) {
        const CellId next = t.neighbor(c, static_cast<int>(random.uniform() * 4));
        if (t.is_infinite(next) || out[next] != out[c]) continue;
        c = next;
        cells.insert(c);
      }
      const std::vector<CellId> list(cells.begin(), cells.end());
      const bool expected = falls_apart(t, out, cells);
      EXPECT_EQ(side_split.splits(list), expected);
      (expected ? apart : together) += 1;
    }
  }
  EXPECT_GT(apart, 50U);
  EXPECT_GT(together, 50U);
}

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
    const DoubtfulRegion region = find_doubtful_region(t, marks, stars);
    EXPECT_EQ(region.cells, cells);
    EXPECT_EQ(region.undecided, undecided);
  }
}

// Where nobody is good, all cells are undecided.
TEST(DoubtfulRegion, LeavesLargeClumpsOnly) {
  std::vector<Point> points = gallery::uniform_cube(300, 1);
  const Triangulation t = delaunay(points).triangulation;
  CellMarks marks;
  marks.good = VertexSet(t.num_vertices(), 0);
  StarCache stars(t);
  const std::size_t all = t.num_finite_cells();
  const DoubtfulRegion asked = find_doubtful_region(t, marks, stars, all);
  EXPECT_EQ(asked.undecided.size(), all);
  EXPECT_EQ(asked.left_cells, 0U);
  EXPECT_EQ(asked.vertices.size(), t.num_vertices());
  const DoubtfulRegion left = find_doubtful_region(t, marks, stars, all - 1);
  EXPECT_TRUE(left.undecided.empty());
  EXPECT_EQ(left.left_cells, all);
  EXPECT_TRUE(left.vertices.empty());
  EXPECT_TRUE(left.cells.empty());
  // A good vertex every now and then parts the cells.
  for (const VertexId v : t.vertices()) {
    marks.good[v] = t.point(v).x > 0.3 && t.point(v).x < 0.6 ? 1 : 0;
  }
  const DoubtfulRegion small = find_doubtful_region(t, marks, stars);
  const DoubtfulRegion some = find_doubtful_region(t, marks, stars, small.undecided.size() / 2);
  EXPECT_GT(some.left_cells, small.undecided.size() / 2);
  EXPECT_GT(some.undecided.size(), 0U);
  EXPECT_EQ(some.left_cells + some.undecided.size(), small.undecided.size());
  for (const CellId c : some.undecided) {
    for (const VertexId v : t.cell(c).vertices) EXPECT_TRUE(some.contains(v));
  }
}

}  // namespace
}  // namespace cocoon
