#include "geom/mesh/used_vertices.h"

#include <gtest/gtest.h>
#include <vector>

namespace cocoon {
namespace {

TEST(UsedVertices, TheOthersAreLeftOut) {
  TriangleMesh mesh;
  for (int k = 0; k < 5; ++k) mesh.points.push_back({double(k), 0, 0});
  mesh.triangles.push_back({VertexId(4U), VertexId(1U), VertexId(3U)});
  EXPECT_EQ(used_vertices(mesh).raw(), (std::vector<std::uint8_t>{0, 1, 0, 1, 1}));
  const VertexId none;
  const std::vector<VertexId> now = {none, VertexId(0U), none, VertexId(1U), VertexId(2U)};
  EXPECT_EQ(leave_out_unused(mesh).raw(), now);
  EXPECT_EQ(mesh.points.raw(), (std::vector<Point>{{1, 0, 0}, {3, 0, 0}, {4, 0, 0}}));
  EXPECT_EQ(mesh.triangles[TriangleId(0U)], (Triangle{VertexId(2U), VertexId(0U), VertexId(1U)}));
}

}  // namespace
}  // namespace cocoon
