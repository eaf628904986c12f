// Updates of a mesh whose triangles are no facets of the triangulation of its vertices.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <gtest/gtest.h>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "cocone/reconstruct.h"
#include "geom/mesh_check.h"
#include "geom/random.h"
#include "geom/triangle_normal.h"
#include "io/point_file.h"
#include "update/update_model.h"

namespace cocoon {
namespace {

using Edge = std::pair<VertexId, VertexId>;

Vec3 normal_of(const TriangleMesh& mesh, const Triangle& t) {
  return triangle_normal(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]).direction;
}

// Random edges have the other diagonal, as long as triangles do not turn over.
TriangleMesh with_other_diagonals(TriangleMesh mesh, std::uint64_t seed) {
  std::map<Edge, TriangleId> left_of;
  for (const TriangleId t : mesh.triangles.ids()) {
    const Triangle& v = mesh.triangles[t];
    for (std::size_t i = 0; i < 3; ++i) left_of[{v[i], v[(i + 1) % 3]}] = t;
  }
  Random random(seed);
  std::set<TriangleId> used;
  std::set<Edge> made;
  for (const auto& [edge, t] : left_of) {
    const auto [a, b] = edge;
    const TriangleId other = left_of.at({b, a});
    if (b < a || random.uniform() > 0.6 || used.contains(t) || used.contains(other)) continue;
    const auto apex = [&](TriangleId of) {
      const Triangle& v = mesh.triangles[of];
      return *std::find_if(v.begin(), v.end(), [&](VertexId w) { return w != a && w != b; });
    };
    const VertexId c = apex(t);
    const VertexId d = apex(other);
    const Triangle first = {c, d, b};
    const Triangle second = {d, c, a};
    const Vec3 n = normal_of(mesh, mesh.triangles[t]);
    const bool holds = dot(n, normal_of(mesh, mesh.triangles[other])) > 0 &&
                       dot(n, normal_of(mesh, first)) > 0 && dot(n, normal_of(mesh, second)) > 0;
    const Edge diagonal = std::minmax(c, d);
    if (!holds || left_of.contains({c, d}) || !made.insert(diagonal).second) continue;
    mesh.triangles[t] = first;
    mesh.triangles[other] = second;
    used.insert(t);
    used.insert(other);
  }
  return mesh;
}

// Nothing has changed, and far from the scan nothing does. What the mesh tells does not fit what
// good vertices do.
TEST(UpdateForeignMesh, ARescanLeavesItAManifold) {
  const std::vector<Point> points =
      read_points(std::string(COCOON_TEST_DATA) + "/models/anchor_dense.off").points;
  const TriangleMesh ours = reconstruct_tight(points).mesh;
  double size = 0;
  for (const Point& p : points) size = std::max(size, distance(p, points[0]));
  const double radius = 0.15 * size;
  for (const std::uint64_t seed : {2, 3, 4, 5}) {
    const TriangleMesh model = with_other_diagonals(ours, seed);
    const MeshReport before = mesh_check(model);
    ASSERT_TRUE(before.is_closed_manifold());
    const Point center = model.points[VertexId(1000)];
    std::vector<std::vector<Point>> clouds(1);
    Random random(seed);
    for (const Point& p : model.points) {
      if (distance(p, center) > radius) continue;
      clouds[0].push_back(p + 0.01 * radius * random.on_unit_sphere());
    }
    const UpdateResult result = update_model(model, clouds);
    ASSERT_EQ(result.status, UpdateStatus::ok) << result.message;
    const MeshReport after = mesh_check(result.mesh);
    EXPECT_TRUE(after.is_closed_manifold()) << "seed " << seed;
    EXPECT_EQ(after.euler, before.euler);
    EXPECT_GT(result.reconstruction.counters.yielded_cells, 0U);
  }
}

}  // namespace
}  // namespace cocoon
