#include "cocone/marking/yielding_labels.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <vector>

#include "cocone/mark_cells.h"
#include "delaunay/delaunay.h"
#include "geom/errors.h"
#include "geom/random/random.h"

namespace cocoon {
namespace {

VertexId operator""_v(unsigned long long v) { return VertexId(static_cast<std::size_t>(v)); }

// Two tetrahedra: with a common edge, a common corner, or none.
SurfaceMesh two_tetrahedra(std::size_t common) {
  SurfaceMesh surface;
  const std::size_t count = 8 - common;
  for (std::size_t i = 0; i < count; ++i) {
    surface.mesh.points.push_back(Point{0, 0, static_cast<double>(i)});
    surface.triangulation_vertex.push_back(VertexId(100 - i));
  }
  for (const std::size_t first : {std::size_t{0}, 4 - common}) {
    const VertexId a(first);
    const VertexId b(first + 1);
    const VertexId c(first + 2);
    const VertexId d(first + 3);
    for (const Triangle& t : {Triangle{a, b, c}, {a, d, b}, {b, d, c}, {c, d, a}}) {
      surface.mesh.triangles.push_back(t);
    }
  }
  return surface;
}

TEST(TouchingVertices, EndsOfOverfullEdgesAndPinchedVertices) {
  EXPECT_TRUE(touching_vertices(two_tetrahedra(0)).empty());
  EXPECT_EQ(touching_vertices(two_tetrahedra(1)), std::vector{97_v});
  EXPECT_EQ(touching_vertices(two_tetrahedra(2)), (std::vector{97_v, 98_v}));
}

class YieldLabels : public ::testing::Test {
 protected:
  YieldLabels() {
    std::vector<Point> points;
    points.reserve(300);
    Random random(7);
    for (int i = 0; i < 300; ++i) points.push_back(random.in_unit_cube());
    triangulation = delaunay(points).triangulation;
    good = VertexSet(triangulation.num_vertices(), 0);
    for (const VertexId v : triangulation.vertices()) good[v] = v.value % 3 == 0 ? 1 : 0;
    labels = IdVector<CellId, CellLabel>(triangulation.num_cells(), CellLabel::unmarked);
    for (const CellId c : triangulation.finite_cells()) {
      if (c.value % 5 != 0) labels[c] = c.value % 2 == 0 ? CellLabel::in : CellLabel::out;
    }
  }

  // Those at a vertex of `at`.
  std::vector<CellId> stars(const std::vector<VertexId>& at) const {
    std::vector<CellId> cells;
    for (const CellId c : triangulation.finite_cells()) {
      const auto& corners = triangulation.cell(c).vertices;
      if (std::find_first_of(corners.begin(), corners.end(), at.begin(), at.end()) !=
          corners.end()) {
        cells.push_back(c);
      }
    }
    return cells;
  }

  // Of these cells those with a good vertex have no label any more, and all others what they had.
  void expect_yielded(const std::vector<CellId>& cells, const std::vector<VertexId>& at,
                      unsigned rings) const {
    IdVector<CellId, CellLabel> expected = labels;
    std::size_t count = 0;
    std::size_t poor = 0;
    for (const CellId c : cells) {
      if (expected[c] == CellLabel::unmarked) continue;
      if (is_poor(triangulation, good, c)) {
        ++poor;
        continue;
      }
      expected[c] = CellLabel::unmarked;
      ++count;
    }
    ASSERT_GT(count, 0U);
    ASSERT_GT(poor, 0U);
    IdVector<CellId, CellLabel> yielded = labels;
    EXPECT_EQ(yield_labels(triangulation, at, rings, good, yielded), count);
    for (const CellId c : triangulation.finite_cells()) EXPECT_EQ(yielded[c], expected[c]);
  }

  Triangulation triangulation;
  VertexSet good;
  IdVector<CellId, CellLabel> labels;
};

TEST_F(YieldLabels, OfCellsWithAGoodVertexThere) {
  const std::vector<VertexId> at = {20_v, 150_v};
  expect_yielded(stars(at), at, 0);
}

TEST_F(YieldLabels, AndOfTheirNeighborsWithARing) {
  const std::vector<VertexId> at = {20_v};
  std::vector<VertexId> around;
  for (const CellId c : stars(at)) {
    const auto& corners = triangulation.cell(c).vertices;
    around.insert(around.end(), corners.begin(), corners.end());
  }
  expect_yielded(stars(around), at, 1);
}

TEST_F(YieldLabels, NowhereIfTheSurfaceTouchesItselfNowhere) {
  IdVector<CellId, CellLabel> yielded = labels;
  EXPECT_EQ(yield_labels(triangulation, {}, 3, good, yielded), 0U);
  for (const CellId c : triangulation.finite_cells()) EXPECT_EQ(yielded[c], labels[c]);
}

TEST_F(YieldLabels, PartsOfAnotherTriangulationAreRefused) {
  IdVector<CellId, CellLabel> few(3, CellLabel::in);
  EXPECT_THROW(yield_labels(triangulation, {}, 0, good, few), InputError);
  EXPECT_THROW(yield_labels(triangulation, {}, 0, VertexSet(3, 0), labels), InputError);
}

}  // namespace
}  // namespace cocoon
