#include "update/checks/loose_parts.h"

#include <algorithm>
#include <gtest/gtest.h>

#include "geom/box.h"
#include "tests/mesh_gallery.h"

namespace cocoon {
namespace {

// Vertices of the first mesh are of the model, those of the others of clouds.
TEST(LooseParts, AreOfNewVerticesAlone) {
  const TriangleMesh cube = gallery::cube();
  const TriangleMesh torus = gallery::torus(12, 8);
  const TriangleMesh all = gallery::join(gallery::join(cube, torus), cube);
  const LooseParts found = loose_parts(all, VertexId(cube.points.size()));
  EXPECT_EQ(found.count, 2U);
  EXPECT_EQ(found.triangles, torus.triangles.size());
  ASSERT_EQ(found.extents.size(), 2U);
  EXPECT_EQ(found.extents[0], norm(box_of(torus.points.span()).size()));
  EXPECT_EQ(found.extents[1], norm(box_of(cube.points.span()).size()));
  EXPECT_EQ(all.points[found.at], *std::min_element(torus.points.begin(), torus.points.end()));
  EXPECT_EQ(loose_parts(all, VertexId(all.points.size())).count, 0U);
  EXPECT_EQ(loose_parts(TriangleMesh(), VertexId(3U)).count, 0U);
}

TEST(LooseParts, OfEquallyLargeOnesTheFirstIsNamed) {
  const TriangleMesh cube = gallery::cube();
  const TriangleMesh all = gallery::join(gallery::join(cube, cube), cube);
  const LooseParts found = loose_parts(all, VertexId(cube.points.size()));
  EXPECT_EQ(found.count, 2U);
  EXPECT_EQ(found.at, VertexId(cube.points.size()));
}

TEST(LooseParts, OneVertexOfTheModelHoldsAPart) {
  const TriangleMesh torus = gallery::torus(12, 8);
  EXPECT_EQ(loose_parts(torus, VertexId(1U)).count, 0U);
  EXPECT_EQ(loose_parts(torus, VertexId(0U)).count, 1U);
}

TEST(LooseParts, ThatShareAVertexAreOne) {
  const TriangleMesh two = gallery::two_tetrahedra_sharing_a_vertex();
  EXPECT_EQ(loose_parts(two, VertexId(0U)).count, 1U);
}

}  // namespace
}  // namespace cocoon
