#include "geom/mesh/weld_vertices.h"

#include <gtest/gtest.h>
#include <vector>

#include "geom/mesh_check.h"
#include "tests/mesh_gallery.h"

namespace cocoon {
namespace {

WeldedMesh weld(const TriangleMesh& mesh) {
  return weld_vertices(mesh, repeated_points(mesh.points.span()));
}

TEST(WeldVertices, TrianglesThatShareNoVerticesBecomeASurface) {
  const TriangleMesh soup = gallery::unshared(gallery::cube());
  EXPECT_EQ(mesh_check(soup).open_edges, 36U);
  const WeldedMesh welded = weld(soup);
  EXPECT_TRUE(mesh_check(welded.mesh).is_closed_manifold());
  EXPECT_EQ(welded.mesh.points.size(), 8U);
  EXPECT_EQ(welded.welded, 28U);
  EXPECT_EQ(welded.left_out_triangles, 0U);
  ASSERT_EQ(welded.vertex_of.size(), soup.points.size());
  for (const VertexId v : soup.points.ids()) {
    const VertexId became = welded.vertex_of[v];
    EXPECT_EQ(welded.mesh.points[became], soup.points[v]);
    EXPECT_LE(welded.source[became], v);
  }
  for (const VertexId v : welded.source.ids()) {
    EXPECT_EQ(welded.vertex_of[welded.source[v]], v);
  }
}

TEST(WeldVertices, ZeroHasNoSignAndTrianglesOfOnePlaceGo) {
  const TriangleMesh mesh = gallery::make_mesh(
      {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-0.0, 0, 0}, {2, 2, 2}}, {{0, 1, 2}, {0, 1, 3}});
  const WeldedMesh welded = weld(mesh);
  EXPECT_EQ(welded.mesh.points.size(), 4U);
  EXPECT_EQ(welded.mesh.triangles.size(), 1U);
  EXPECT_EQ(welded.left_out_triangles, 1U);
  EXPECT_EQ(welded.vertex_of[VertexId(4)], VertexId(3));
}

TEST(WeldVertices, LeavesAMeshWithoutEqualPointsAsItIs) {
  EXPECT_EQ(weld(gallery::cube()).mesh, gallery::cube());
  EXPECT_EQ(weld({}).mesh, TriangleMesh());
}

}  // namespace
}  // namespace cocoon
