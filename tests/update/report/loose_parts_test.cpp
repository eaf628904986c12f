#include "update/report/loose_parts.h"

#include <gtest/gtest.h>

#include "tests/mesh_gallery.h"

namespace cocoon {
namespace {

// Vertices of the first mesh are of the model, those of the others of clouds.
TEST(LooseParts, AreOfNewVerticesAlone) {
  const TriangleMesh cube = gallery::cube();
  const TriangleMesh torus = gallery::torus(12, 8);
  const TriangleMesh all = gallery::join(gallery::join(cube, torus), cube);
  const LooseParts found = loose_parts(all.triangles.span(), VertexId(cube.points.size()));
  EXPECT_EQ(found.count, 2U);
  EXPECT_EQ(found.triangles, torus.triangles.size());
  EXPECT_EQ(found.at, VertexId(cube.points.size()));
  EXPECT_EQ(loose_parts(all.triangles.span(), VertexId(all.points.size())).count, 0U);
  EXPECT_EQ(loose_parts({}, VertexId(3U)).count, 0U);
}

// One vertex of the model holds all that hangs together with it, however far away.
TEST(LooseParts, AreNotHeldByTheModel) {
  const TriangleMesh torus = gallery::torus(12, 8);
  EXPECT_EQ(loose_parts(torus.triangles.span(), VertexId(1U)).count, 0U);
  const LooseParts whole = loose_parts(torus.triangles.span(), VertexId(0U));
  EXPECT_EQ(whole.count, 1U);
  EXPECT_EQ(whole.at, VertexId(0U));
}

}  // namespace
}  // namespace cocoon
