#include "geom/mesh/sharp_edges.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "tests/mesh_gallery.h"

namespace cocoon {
namespace {

std::size_t count(const TriangleMesh& mesh, double cosine = default_smooth_cosine) {
  return sharp_edges(link_mesh(mesh), cosine).size();
}

// Of a cube's 18 edges six are diagonals of its sides.
TEST(SharpEdges, AreThoseWhereNormalsDiffer) {
  const TriangleMesh cube = gallery::cube();
  EXPECT_EQ(count(cube), 12U);
  EXPECT_EQ(count(cube, -0.5), 0U);
  EXPECT_EQ(count(gallery::flipped(cube)), 12U);
}

TEST(SharpEdges, OpenOnesAreSharp) {
  TriangleMesh open = gallery::cube();
  open.triangles.raw().erase(open.triangles.raw().begin());
  EXPECT_EQ(count(open, -0.5), 3U);
  EXPECT_EQ(count({}), 0U);
}

// The list is in the order of the first halfedges, however many triangles share an edge.
TEST(SharpEdges, OfAFanAboutOneEdge) {
  TriangleMesh fan;
  for (const Point& end : {Point{0, 0, 0}, Point{0, 0, 1}}) fan.points.push_back(end);
  for (int k = 0; k < 200000; ++k) {
    const VertexId tip = fan.points.push_back({std::cos(0.1 * k), std::sin(0.1 * k), 0.001 * k});
    fan.triangles.push_back({VertexId(0), VertexId(1), tip});
  }
  const std::vector<Halfedge> sharp = sharp_edges(link_mesh(fan));
  EXPECT_EQ(sharp.size(), 1 + 2 * fan.triangles.size());
  EXPECT_TRUE(std::is_sorted(sharp.begin(), sharp.end()));
}

}  // namespace
}  // namespace cocoon
