#include "cocone/marking/known_hollows.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <vector>

#include "cocone/clean_up/kept_reach.h"
#include "cocone/facets/cell_order.h"
#include "delaunay/delaunay.h"
#include "tests/cocone/sample_shapes.h"

namespace cocoon {
namespace {

Point middle_of(const Triangulation& t, CellId c) {
  const auto [p, q, r, s] = sorted_corners(t, c);
  return 0.25 * ((p + q) + (r + s));
}

// Between two spheres cells are IN; those within the inner one are known, and pockets of cells
// at the outer one, where infinity reaches all samples.
TEST(KnownHollows, AreWhereInfinityReachesNoSample) {
  std::vector<Point> points = shapes::noisy_sphere(800, 0.05, 1);
  for (const Point& p : shapes::sphere(400, 2)) points.push_back(0.5 * p);
  const Triangulation t = delaunay(points).triangulation;
  IdVector<CellId, CellLabel> known(t.num_cells(), CellLabel::unmarked);
  IdVector<CellId, std::uint8_t> out(t.num_cells(), 0);
  std::vector<CellId> inner;
  CellId pocket;
  IdVector<VertexId, std::uint8_t> is_on_hull(t.num_vertices(), 0);
  for (const CellId c : t.infinite_cells()) {
    out[c] = 1;
    for (int i = 0; i < 3; ++i) is_on_hull[t.vertex(c, i)] = 1;
  }
  for (const CellId c : t.finite_cells()) {
    const auto& corners = t.cell(c).vertices;
    const auto is_inner = [&](VertexId v) { return norm(t.point(v) - Point{}) < 0.75; };
    const bool all = std::all_of(corners.begin(), corners.end(), is_inner);
    const bool is_pocket =
        std::all_of(corners.begin(), corners.end(), [&](VertexId v) { return is_on_hull[v] != 0; });
    if (all && norm(middle_of(t, c) - Point{}) < 0.45) {
      known[c] = CellLabel::out;
      out[c] = 1;
      inner.push_back(c);
    }
    if (is_pocket) {
      known[c] = CellLabel::out;
      pocket = c;
    }
  }
  ASSERT_GT(inner.size(), 50U);
  ASSERT_FALSE(pocket.is_none());
  IdVector<CellId, std::uint8_t> reached = reached_from_infinity(t, out);
  EXPECT_EQ(known_hollow_cells(t, known, reached), inner);
  extend_reach(t, out, {inner.front()}, reached);
  EXPECT_EQ(std::count_if(inner.begin(), inner.end(), [&](CellId c) { return reached[c] == 0; }),
            0);
  EXPECT_EQ(reached[pocket], 0);
  EXPECT_TRUE(known_hollow_cells(t, known, reached).empty());
}

}  // namespace
}  // namespace cocoon
