#include "cocone/cell_heights.h"

#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "delaunay/delaunay.h"
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

}  // namespace
}  // namespace cocoon
