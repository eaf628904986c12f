#include "cocone/solid/cell_heights.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <gtest/gtest.h>
#include <map>
#include <vector>

#include "cocone/facets/cell_order.h"
#include "delaunay/delaunay.h"
#include "tests/cocone/renumbered.h"
#include "tests/cocone/sample_shapes.h"
#include "tests/mesh_gallery.h"

namespace cocoon {
namespace {

// A tetrahedron with its centroid 1 below the upper side of a box, and one corner above it.
TEST(CellHeights, AreThoseOfCentroidAndMiddlesOfEdges) {
  const TriangleMesh solid = gallery::translated(gallery::box(20, 20, 10), {-10, -10, -10});
  const std::vector<Point> corners = {{0, 0, 2}, {3, 0, -2}, {-3, 3, -2}, {-3, -3, -2}};
  const Triangulation triangulation = delaunay(corners).triangulation;
  const std::vector<CellId> cells(1, *triangulation.finite_cells().begin());
  const CellHeights heights =
      cell_heights(triangulation, cells, solid, CellPlaces::centroid_and_edges).front();
  EXPECT_DOUBLE_EQ(heights.lowest, -2);  // of an edge below
  EXPECT_DOUBLE_EQ(heights.highest, 0);  // of the edges to the upper corner
  EXPECT_DOUBLE_EQ(heights.deepest(), -2);
  EXPECT_DOUBLE_EQ(heights.longest_edge, std::sqrt(45.0));
  EXPECT_FALSE(heights.crosses(0));
  const std::vector<Point> raised = {{0, 0, 4}, {3, 0, -2}, {-3, 3, -2}, {-3, -3, -2}};
  const Triangulation higher = delaunay(raised).triangulation;
  const std::vector<CellId> cell(1, *higher.finite_cells().begin());
  const CellHeights crossing =
      cell_heights(higher, cell, solid, CellPlaces::centroid_and_edges).front();
  EXPECT_DOUBLE_EQ(crossing.highest, 1);
  EXPECT_TRUE(crossing.crosses(0.1));
  EXPECT_FALSE(crossing.crosses(0.2));
  EXPECT_EQ(crossing.at_highest.z, 1);
  EXPECT_EQ(crossing.at_lowest.z, -2);
  const CellHeights middle = cell_heights(higher, cell, solid, CellPlaces::centroid).front();
  EXPECT_DOUBLE_EQ(middle.lowest, -0.5);
  EXPECT_DOUBLE_EQ(middle.highest, 0);
  EXPECT_DOUBLE_EQ(middle.longest_edge, crossing.longest_edge);
}

// Cells of which the centroid alone answers the question get the same answer as those looked at in
// all places.
TEST(CellHeights, OfSettledCellsAnswerTheSame) {
  const TriangleMesh solid = gallery::translated(gallery::box(20, 14, 8), {-10, -7, -4});
  std::vector<Point> points = shapes::noisy_sphere(1500, 0.2, 2);
  for (Point& p : points) p = 9.0 * p;
  const Triangulation triangulation = delaunay(points).triangulation;
  std::vector<CellId> cells;
  for (const CellId c : triangulation.finite_cells()) cells.push_back(c);
  constexpr CellPlaces places = CellPlaces::centroid_and_edges;
  const std::vector<CellHeights> all = cell_heights(triangulation, cells, solid, places);
  std::size_t settled = 0;
  const auto count = [&](bool is_settled) {
    settled += is_settled ? 1U : 0U;
    return is_settled;
  };
  const std::vector<CellHeights> sides =
      cell_heights(triangulation, cells, solid, places, [&](const CentroidHeight& middle) {
        return count(std::abs(middle.height) > middle.most_beyond());
      });
  for (std::size_t k = 0; k < cells.size(); ++k) {
    EXPECT_EQ(sides[k].deepest() > 0, all[k].deepest() > 0);
    EXPECT_LE(std::abs(sides[k].deepest()), std::abs(all[k].deepest()));
  }
  EXPECT_GT(settled, cells.size() / 10);
  EXPECT_LT(settled, cells.size());
  settled = 0;
  const std::vector<CellHeights> crossings =
      cell_heights(triangulation, cells, solid, places, [&](const CentroidHeight& middle) {
        return count(middle.most_beyond() <= 0.02 * middle.longest_edge);
      });
  for (std::size_t k = 0; k < cells.size(); ++k) {
    ASSERT_EQ(crossings[k].crosses(0.02), all[k].crosses(0.02));
    if (!all[k].crosses(0.02)) continue;
    EXPECT_EQ(crossings[k].at_lowest, all[k].at_lowest);
  }
  EXPECT_GT(settled, cells.size() / 10);
  EXPECT_LT(settled, cells.size());
}

using HeightsByCorners = std::map<std::array<Point, 4>, CellHeights>;

HeightsByCorners all_heights(const Triangulation& triangulation, const TriangleMesh& solid) {
  std::vector<CellId> cells;
  for (const CellId c : triangulation.finite_cells()) cells.push_back(c);
  const std::vector<CellHeights> heights =
      cell_heights(triangulation, cells, solid, CellPlaces::centroid_and_edges);
  HeightsByCorners result;
  for (std::size_t k = 0; k < cells.size(); ++k) {
    result[sorted_corners(triangulation, cells[k])] = heights[k];
  }
  return result;
}

TEST(CellHeights, DoNotDependOnNumbers) {
  const TriangleMesh solid = gallery::translated(gallery::box(20, 20, 20), {-10, -10, -10});
  std::vector<Point> points = shapes::noisy_sphere(500, 0.1, 1);
  for (Point& p : points) p = 10.0 * p;
  const Triangulation triangulation = delaunay(points).triangulation;
  const HeightsByCorners expected = all_heights(triangulation, solid);
  for (const std::uint64_t seed : {1U, 2U}) {
    for (const auto& [corners, heights] : all_heights(renumbered(triangulation, seed), solid)) {
      const CellHeights& before = expected.at(corners);
      EXPECT_EQ(heights.lowest, before.lowest);
      EXPECT_EQ(heights.highest, before.highest);
      EXPECT_EQ(heights.at_lowest, before.at_lowest);
      EXPECT_EQ(heights.at_highest, before.at_highest);
      EXPECT_EQ(heights.longest_edge, before.longest_edge);
    }
  }
}

}  // namespace
}  // namespace cocoon
