#include "update/checks/closed_openings.h"

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
  const ClosedOpenings all = closed_openings(index, irregular_sides(index), patch, map);
  EXPECT_EQ(all.edges, mesh_check(patch).open_edges);
  ASSERT_FALSE(all.at.is_none());
  map[all.at] = {};  // on the rim, with two open edges
  const ClosedOpenings rest = closed_openings(index, irregular_sides(index), patch, map);
  EXPECT_EQ(rest.edges, all.edges - 2);
  EXPECT_NE(rest.at, all.at);
}

// A sample that fills the opening beside one of its edges.
TEST(ClosedOpenings, AreNotWhereSamplesFillThem) {
  const TriangleMesh patch = gallery::open_patch(4, 5);
  const IdVector<VertexId, VertexId> map = all_stay(patch);
  const ModelIndex index(patch);
  const std::size_t all = mesh_check(patch).open_edges;
  TriangleMesh updated = patch;
  const VertexId sample(updated.points.size());
  updated.points.push_back({-1, -1, 0});
  updated.triangles.push_back({sample, VertexId(1U), VertexId(0U)});
  EXPECT_EQ(closed_openings(index, irregular_sides(index), updated, map).edges, all - 1);
  // One far off does not: the surface was closed over to it.
  EXPECT_EQ(closed_openings(index, irregular_sides(index), updated, map, {.reach = 0.1}).edges,
            all);
  const TriangleId last(updated.triangles.size() - 1);
  updated.triangles[last][0] = VertexId(patch.points.size() - 1);
  EXPECT_EQ(closed_openings(index, irregular_sides(index), updated, map).edges, all);  // no sample
}

TEST(ClosedOpenings, AreNotWhereSheetsTouch) {
  for (const TriangleMesh& mesh : {gallery::cube(), gallery::two_tetrahedra_sharing_an_edge()}) {
    const ModelIndex index(mesh);
    const ClosedOpenings none =
        closed_openings(index, irregular_sides(index), mesh, all_stay(mesh));
    EXPECT_EQ(none.edges, 0U);
    EXPECT_TRUE(none.at.is_none());
  }
}

TEST(ClosedOpenings, WantTheMapOfTheModel) {
  const TriangleMesh cube = gallery::cube();
  EXPECT_THROW((void)closed_openings(ModelIndex(cube), {}, cube, {}), InputError);
}

}  // namespace
}  // namespace cocoon
