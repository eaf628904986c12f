#include "geom/mesh/triangles_at_vertices.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <map>
#include <set>

#include "tests/mesh_gallery.h"

namespace cocoon {
namespace {

TEST(TrianglesAtVertices, AgreeWithCountingFromScratch) {
  for (const TriangleMesh& mesh :
       {gallery::cube(), gallery::open_patch(3, 4), gallery::torus(7, 5),
        gallery::two_tetrahedra_sharing_an_edge(), gallery::two_tetrahedra_sharing_a_vertex(),
        gallery::shuffled(gallery::sphere(2), 3), gallery::random_soup(200, 3), TriangleMesh{}}) {
    std::map<VertexId, std::set<TriangleId>> expected;
    for (const TriangleId t : mesh.triangles.ids()) {
      for (const VertexId v : mesh.triangles[t]) expected[v].insert(t);
    }
    const TrianglesAtVertices at = triangles_at_vertices(mesh);
    for (const VertexId v : mesh.points.ids()) {
      EXPECT_TRUE(std::equal(at[v].begin(), at[v].end(), expected[v].begin(), expected[v].end()));
    }
  }
}

TEST(TrianglesAtVertices, HaveATriangleThatRepeatsAVertexOnce) {
  const TriangleMesh mesh =
      gallery::make_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 1, 1}, {2, 2, 2}});
  const TrianglesAtVertices at = triangles_at_vertices(mesh);
  EXPECT_EQ(at[VertexId(1)].size(), 2U);
  EXPECT_EQ(at[VertexId(2)].size(), 2U);
}

}  // namespace
}  // namespace cocoon
