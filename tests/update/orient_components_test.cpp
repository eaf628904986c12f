#include "update/orient_components.h"

#include <gtest/gtest.h>
#include <utility>

#include "geom/random.h"
#include "tests/update/hand_made_models.h"

namespace cocoon {
namespace {

double normal_z(const TriangleMesh& mesh, TriangleId t) {
  const auto& [a, b, c] = mesh.triangles[t];
  return cross(mesh.points[b] - mesh.points[a], mesh.points[c] - mesh.points[a]).z;
}

TEST(OrientComponents, TurnsTrianglesToAgreeWithTheFirst) {
  TriangleMesh mesh = testing::grid_plane(6);
  Random random(7);
  for (const TriangleId t : mesh.triangles.ids()) {
    if (t.value > 0 && random.uniform() < 0.5) {
      std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
    }
  }
  const SurfaceComponents parts = orient_components(mesh);
  EXPECT_EQ(parts.triangles, std::vector<std::size_t>{72});
  EXPECT_EQ(parts.conflicts, 0U);
  for (const TriangleId t : mesh.triangles.ids()) EXPECT_GT(normal_z(mesh, t), 0) << t.value;
}

TEST(OrientComponents, SeparatePartsAreSeparateComponents) {
  TriangleMesh mesh = testing::grid_plane(2);
  const std::size_t vertices = mesh.points.size();
  const TriangleMesh other = testing::grid_plane(3);
  for (const Point& p : other.points) mesh.points.push_back(p + Vec3{10, 0, 0});
  for (Triangle t : other.triangles) {
    for (VertexId& v : t) v = VertexId(v.index() + vertices);
    mesh.triangles.push_back(t);
  }
  const SurfaceComponents parts = orient_components(mesh);
  EXPECT_EQ(parts.triangles, (std::vector<std::size_t>{8, 18}));
  EXPECT_EQ(parts.component_of[TriangleId(7)], 0U);
  EXPECT_EQ(parts.component_of[TriangleId(8)], 1U);
}

TEST(OrientComponents, MoebiusStripHasAConflict) {
  TriangleMesh mesh;  // five triangles, each sharing an edge with the next, closed with a twist
  for (std::size_t i = 0; i < 5; ++i) {
    mesh.points.push_back({static_cast<double>(i), static_cast<double>(i * i), 1});
  }
  for (std::size_t i = 0; i < 5; ++i) {
    mesh.triangles.push_back(
        {testing::vertex(i), testing::vertex((i + 1) % 5), testing::vertex((i + 2) % 5)});
  }
  EXPECT_EQ(orient_components(mesh).conflicts, 1U);
}

TEST(OrientComponents, EmptySurface) {
  TriangleMesh mesh;
  EXPECT_TRUE(orient_components(mesh).triangles.empty());
}

}  // namespace
}  // namespace cocoon
