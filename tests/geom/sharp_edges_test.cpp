#include "geom/sharp_edges.h"

#include <gtest/gtest.h>

#include "tests/mesh_gallery.h"

namespace cocoon {
namespace {

std::size_t count(const TriangleMesh& mesh, double cosine = default_sharp_cosine) {
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

}  // namespace
}  // namespace cocoon
