// An update does not depend on where model and clouds lie in space.
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "cocone/reconstruct.h"
#include "io/sample_models.h"
#include "update/update_model.h"

namespace cocoon {
namespace {

// Turned about no axis of coordinates, and shifted by more than the models are wide.
Point moved(const Point& p) {
  const Vec3 u = unit(Vec3{1, 2, 3});
  const Vec3 v = unit(cross(u, Vec3{3, -1, 0.5}));
  return Point{dot(p, u), dot(p, v), dot(p, cross(u, v))} + Vec3{-170, 260, 90};
}

std::vector<std::uint8_t> replaced(const UpdateResult& result) {
  std::vector<std::uint8_t> flags;
  for (const PointId p : result.replacement.point_of_vertex) flags.push_back(p.is_none() ? 1 : 0);
  return flags;
}

class UpdateRigidMotion : public ::testing::TestWithParam<const char*> {};

// The samples have no ties, so even the triangles are the same. But a rim point that is closest to
// an edge of the model has two closest facets, and the axes tell which of them is taken: one more
// facet in the border may change the angle of an edge.
TEST_P(UpdateRigidMotion, ChangesNothing) {
  SampleModel sample = sample_model(GetParam(), {.points = 4000, .cloud_points = 5000});
  TriangleMesh model = reconstruct_tight(sample.initial).mesh;
  const UpdateResult expected = update_model(model, sample.clouds);
  ASSERT_EQ(expected.status, UpdateStatus::ok) << expected.message;
  ASSERT_GT(expected.replacement.vertices.replaced, 100U);

  for (Point& p : model.points) p = moved(p);
  for (std::vector<Point>& cloud : sample.clouds) {
    for (Point& p : cloud) p = moved(p);
  }
  const UpdateResult result = update_model(model, sample.clouds);
  ASSERT_EQ(result.status, UpdateStatus::ok) << result.message;
  EXPECT_EQ(replaced(result), replaced(expected));
  EXPECT_EQ(result.vertex_map, expected.vertex_map);
  EXPECT_EQ(result.euler, expected.euler);
  EXPECT_TRUE(result.mesh.triangles == expected.mesh.triangles);
  EXPECT_EQ(result.regions.regions.size(), expected.regions.regions.size());
  for (std::size_t c = 0; c < expected.clouds.size(); ++c) {
    EXPECT_EQ(result.clouds[c].boundary_points, expected.clouds[c].boundary_points);
    EXPECT_NEAR(result.clouds[c].margin_deg, expected.clouds[c].margin_deg, 0.5);
  }
}

INSTANTIATE_TEST_SUITE_P(Models, UpdateRigidMotion, ::testing::Values("block", "airbag"),
                         [](const auto& named) { return std::string(named.param); });

}  // namespace
}  // namespace cocoon
