// The update of a real scan where it is scanned again, denser and changed.
#include <cmath>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "cocone/reconstruct.h"
#include "geom/mesh_check.h"
#include "geom/random/random.h"
#include "geom/random/random_point.h"
#include "geom/search/closest_facet.h"
#include "geom/search/nearest_point.h"
#include "io/point_file.h"
#include "tests/end_to_end/local_update.h"
#include "update/model/model_index.h"
#include "update/update_model.h"

namespace cocoon {
namespace {

using testing::Clouds;
using testing::expect_local_update;
using testing::hill;

// A scanned statuette of genus 1: a patch of its side is replaced by a denser one with a bump.
TEST(UpdateOfAScan, KittenByADenserPatch) {
  const std::vector<Point> initial =
      read_points(std::string(COCOON_TEST_DATA) + "/points/kitten.xyz").points;
  const TriangleMesh model = reconstruct_tight(initial).mesh;
  const MeshReport before = mesh_check(model);
  ASSERT_TRUE(before.is_closed_manifold());

  // Points on the facets within 0.15 of a vertex, pushed outward by a hill.
  const ModelIndex index(model);
  const PointId middle = NearestPointTree(model.points.span()).nearest({0.3, 0, 0}).point;
  const Point center = model.points[VertexId(middle.index())];
  Random random(12);
  Clouds clouds(1);
  const double spacing = 0.009;  // half of the model's
  for (const TriangleId t : model.triangles.ids()) {
    const auto& [a, b, c] = model.triangles[t];
    const Vec3 ab = model.points[b] - model.points[a];
    const Vec3 ac = model.points[c] - model.points[a];
    const double wanted = 6 * 0.5 * norm(cross(ab, ac)) / (spacing * spacing);
    for (int k = 0; k < static_cast<int>(wanted + random.uniform()); ++k) {
      const Point p = random_point_in(model.points[a], model.points[b], model.points[c], random);
      if (distance(p, center) > 0.15) continue;
      const Point moved = p + 0.03 * hill(distance(p, center), 0.09) * index.normal(t);
      // Dart throwing: no two points closer than the spacing.
      bool apart = true;
      for (const Point& q : clouds[0]) apart &= distance(moved, q) > spacing;
      if (apart) clouds[0].push_back(moved);
    }
  }
  ASSERT_GT(clouds[0].size(), 400U);

  const UpdateResult result = update_model(model, clouds);
  expect_local_update(
      model, clouds, result, [&](const Point& p) { return distance(p, center) < 0.11; },
      [&](const Point& p) { return distance(p, center) > 0.17; });
  EXPECT_EQ(mesh_check(result.mesh).euler, before.euler);
  // It follows the patch: every cloud point lies on it, up to a fraction of the spacing.
  const ClosestFacetTree updated(result.mesh);
  for (const Point& p : clouds[0]) {
    EXPECT_LT(std::sqrt(updated.closest(p).squared_distance), spacing / 2);
  }
  // And nothing moved elsewhere.
  for (const VertexId v : model.points.ids()) {
    if (distance(model.points[v], center) < 0.17) continue;
    EXPECT_EQ(result.mesh.points[result.vertex_map[v]], model.points[v]);
  }
}

}  // namespace
}  // namespace cocoon
