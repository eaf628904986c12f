#include "update/model/mesh_change.h"

#include <gtest/gtest.h>

#include "tests/mesh_gallery.h"

namespace cocoon {
namespace {

IdVector<VertexId, VertexId> identity(std::size_t count) {
  IdVector<VertexId, VertexId> map;
  for (const VertexId v : id_range<VertexId>(count)) map.push_back(v);
  return map;
}

TEST(MeshChange, BetweenEqualMeshesIsEmpty) {
  const TriangleMesh mesh = gallery::sphere(2);
  EXPECT_TRUE(mesh_change(mesh, mesh, identity(mesh.points.size())).empty());
}

TEST(MeshChange, InAnyOrderAsInCanonicalOrder) {
  TriangleMesh before = gallery::sphere(2);
  canonicalize_triangles(before);
  TriangleMesh after = before;
  // Vertex 3 goes, and vertex 5 gets another triangle turned over.
  IdVector<VertexId, VertexId> map = identity(before.points.size());
  map[VertexId(3)] = VertexId();
  std::vector<Triangle> kept;
  for (const Triangle& t : before.triangles) {
    if (t[0] != VertexId(3) && t[1] != VertexId(3) && t[2] != VertexId(3)) kept.push_back(t);
  }
  std::swap(kept[7][1], kept[7][2]);
  const Triangle turned = kept[7];
  after.triangles = IdVector<TriangleId, Triangle>(kept);
  canonicalize_triangles(after);
  const MeshChange in_order = mesh_change(before, after, map);
  EXPECT_EQ(in_order.removed.size(), before.triangles.size() - kept.size() + 1);
  EXPECT_EQ(in_order.added, std::vector<Triangle>{turned});

  for (TriangleMesh* mesh : {&before, &after}) {
    std::vector<Triangle> reversed(mesh->triangles.raw().rbegin(), mesh->triangles.raw().rend());
    for (Triangle& t : reversed) t = {t[1], t[2], t[0]};
    mesh->triangles = IdVector<TriangleId, Triangle>(reversed);
    const MeshChange any_order = mesh_change(before, after, map);
    EXPECT_EQ(any_order.removed, in_order.removed);
    EXPECT_EQ(any_order.added, in_order.added);
  }
}

}  // namespace
}  // namespace cocoon
