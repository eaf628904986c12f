#include "update/model/irregular_sides.h"

#include <gtest/gtest.h>

#include "geom/mesh_check.h"
#include "tests/mesh_gallery.h"

namespace cocoon {
namespace {

TEST(IrregularSides, AreNoneOfAClosedMesh) {
  TriangleMesh cube = gallery::cube();
  EXPECT_TRUE(irregular_sides(ModelIndex(cube)).empty());
  EXPECT_TRUE(irregular_sides(ModelIndex::of_smooth(cube)).empty());
  cube.triangles.push_back({VertexId(0U), VertexId(0U), VertexId(1U)});
  EXPECT_TRUE(irregular_sides(ModelIndex(cube)).empty());
}

TEST(IrregularSides, OfAnOpenMeshAreItsOpenEdges) {
  const TriangleMesh patch = gallery::open_patch(4, 5);
  EXPECT_EQ(irregular_sides(ModelIndex(patch)).size(), mesh_check(patch).open_edges);
}

// An edge of four triangles is a side of each; a triangle with a corner twice has none.
TEST(IrregularSides, AreOneForEachTriangle) {
  TriangleMesh mesh = gallery::two_tetrahedra_sharing_an_edge();
  const std::vector<EdgeSide> sides = irregular_sides(ModelIndex(mesh));
  ASSERT_EQ(sides.size(), 4U);
  EXPECT_EQ(sides.front(), sides.back());
  EXPECT_LT(sides.front().low, sides.front().high);
  mesh.triangles.push_back({VertexId(0U), VertexId(0U), VertexId(1U)});
  EXPECT_EQ(irregular_sides(ModelIndex(mesh)).size(), 4U);
}

}  // namespace
}  // namespace cocoon
