#include "update/report/closed_openings.h"

#include <gtest/gtest.h>

#include "geom/errors.h"
#include "geom/mesh_check.h"
#include "tests/mesh_gallery.h"

namespace cocoon {
namespace {

// Each vertex stays what it was.
IdVector<VertexId, VertexId> all_stay(const TriangleMesh& mesh) {
  IdVector<VertexId, VertexId> map(mesh.points.size());
  for (const VertexId v : map.ids()) map[v] = v;
  return map;
}

TEST(ClosedOpenings, AreOpenEdgesThatStay) {
  const TriangleMesh patch = gallery::open_patch(4, 5);
  IdVector<VertexId, VertexId> map = all_stay(patch);
  const ModelIndex index(patch);
  const ClosedOpenings all = closed_openings(index, map);
  EXPECT_EQ(all.edges, mesh_check(patch).open_edges);
  ASSERT_FALSE(all.at.is_none());
  map[all.at] = {};  // on the rim, with two open edges
  const ClosedOpenings rest = closed_openings(index, map);
  EXPECT_EQ(rest.edges, all.edges - 2);
  EXPECT_NE(rest.at, all.at);
}

TEST(ClosedOpenings, AreNotWhereSheetsTouch) {
  for (const TriangleMesh& mesh : {gallery::cube(), gallery::two_tetrahedra_sharing_an_edge()}) {
    const ClosedOpenings none = closed_openings(ModelIndex(mesh), all_stay(mesh));
    EXPECT_EQ(none.edges, 0U);
    EXPECT_TRUE(none.at.is_none());
  }
}

TEST(ClosedOpenings, WantTheMapOfTheModel) {
  const TriangleMesh cube = gallery::cube();
  EXPECT_THROW((void)closed_openings(ModelIndex(cube), {}), InputError);
}

}  // namespace
}  // namespace cocoon
