#include "cocone/kept/points_at_vertices.h"

#include <array>
#include <gtest/gtest.h>

namespace cocoon {
namespace {

IdVector<PointId, VertexId> vertices(std::initializer_list<std::uint32_t> numbers) {
  IdVector<PointId, VertexId> list;
  for (const std::uint32_t n : numbers) list.push_back(VertexId(n));
  return list;
}

TEST(PointsAtVertices, FollowChanges) {
  PointsAtVertices points;
  EXPECT_FALSE(points.is_known());
  points.list(vertices({3, 0, 2, 1}), PointId(0), 4);
  ASSERT_TRUE(points.is_known());
  EXPECT_EQ(points[VertexId(3)], PointId(0));
  EXPECT_EQ(points[VertexId(2)], PointId(2));
  // Vertex 0 goes with its point, and one comes to a new slot, behind all others.
  points.forget(std::array{VertexId(0)}, 5);
  EXPECT_TRUE(points[VertexId(0)].is_none());
  EXPECT_TRUE(points[VertexId(4)].is_none());
  points.list(vertices({3, 2, 1, 4}), PointId(1), 5);
  EXPECT_EQ(points[VertexId(3)], PointId(0));
  EXPECT_EQ(points[VertexId(2)], PointId(1));
  EXPECT_EQ(points[VertexId(4)], PointId(3));
  // The gap is closed.
  points.renumber(std::array{Renumbering::Move{VertexId(4), VertexId(0)}}, 4);
  EXPECT_EQ(points[VertexId(0)], PointId(3));
  points.clear();
  EXPECT_FALSE(points.is_known());
  points.renumber({}, 4);
  EXPECT_FALSE(points.is_known());
}

}  // namespace
}  // namespace cocoon
