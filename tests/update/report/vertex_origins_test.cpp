#include "update/report/vertex_origins.h"

#include <gtest/gtest.h>
#include <vector>

namespace cocoon {
namespace {

// A model of three vertices, the second one replaced, and two clouds that repeat points; vertex by
// vertex of a result that uses them in another order and leaves one out.
TEST(VertexOrigins, TheFirstOfEqualPointsInTheOrderModelThenClouds) {
  UpdateResult result;
  Replacement& replacement = result.replacement;
  replacement.points.resize(4);  // model 0, model 2, cloud 0 point 1, cloud 1 point 0
  replacement.point_of_vertex =
      IdVector<VertexId, PointId>(std::vector<PointId>{PointId(0), PointId(), PointId(1)});
  replacement.point_of_cloud_point = {
      IdVector<PointId, PointId>(std::vector<PointId>{PointId(1), PointId(2)}),
      IdVector<PointId, PointId>(std::vector<PointId>{PointId(3), PointId(2), PointId(0)})};
  result.mesh.points.resize(3);
  result.reconstruction.point_of_vertex =
      IdVector<VertexId, PointId>(std::vector<PointId>{PointId(1), PointId(2), PointId(3)});
  EXPECT_EQ(vertex_origins(result).raw(), (std::vector<VertexOrigin>{{0, 2}, {1, 1}, {2, 0}}));
}

}  // namespace
}  // namespace cocoon
