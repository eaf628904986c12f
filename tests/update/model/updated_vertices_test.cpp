#include "update/model/updated_vertices.h"

#include <gtest/gtest.h>
#include <vector>

namespace cocoon {
namespace {

using Map = std::vector<VertexId>;

// Of four vertices the second one went; of the three points that are left one is not on the
// surface, and the others are its vertices in another order.
TEST(UpdatedVertices, AreThoseOfTheSurface) {
  Replacement replacement;
  replacement.points.resize(3);
  replacement.point_of_vertex =
      IdVector<VertexId, PointId>(std::vector{PointId(0), PointId(), PointId(1), PointId(2)});
  ReconstructResult reconstruction;
  EXPECT_EQ(updated_vertices(replacement, reconstruction).raw(),
            (Map{VertexId(0U), VertexId(), VertexId(1U), VertexId(2U)}));
  reconstruction.unused_points = 1;
  reconstruction.point_of_vertex = IdVector<VertexId, PointId>(std::vector{PointId(2), PointId(0)});
  EXPECT_EQ(updated_vertices(replacement, reconstruction).raw(),
            (Map{VertexId(1U), VertexId(), VertexId(), VertexId(0U)}));
}

// The last vertex of the model is at the place of its first one.
TEST(UpdatedVertices, CloudsBeginBehindAllThatWasKept) {
  const auto map = [](std::initializer_list<VertexId> list) {
    return IdVector<VertexId, VertexId>(std::vector<VertexId>(list));
  };
  EXPECT_EQ(first_vertex_of_clouds(map({VertexId(0), VertexId(1), VertexId(2), VertexId(0)})),
            VertexId(3));
  EXPECT_EQ(first_vertex_of_clouds(map({VertexId(0), VertexId(1), VertexId()})), VertexId(2));
  EXPECT_EQ(first_vertex_of_clouds(map({VertexId(), VertexId()})), VertexId(0));
}

}  // namespace
}  // namespace cocoon
