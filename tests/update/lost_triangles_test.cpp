#include "update/lost_triangles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <iterator>
#include <vector>

namespace cocoon {
namespace {

TriangleMesh mesh_of(std::size_t points, const std::vector<std::array<std::size_t, 3>>& triangles) {
  TriangleMesh mesh;
  for (std::size_t i = 0; i < points; ++i) mesh.points.push_back({static_cast<double>(i), 0, 0});
  for (const auto& [a, b, c] : triangles) {
    mesh.triangles.push_back({VertexId(a), VertexId(b), VertexId(c)});
  }
  return mesh;
}

// Of four triangles one has a vertex that goes; of the others one comes back with its corners in
// another order, one is turned over, and one is not there.
TEST(LostTriangles, CountsThoseWhoseVerticesStay) {
  const TriangleMesh model = mesh_of(6, {{0, 1, 2}, {2, 1, 3}, {3, 4, 0}, {4, 5, 0}});
  IdVector<VertexId, VertexId> map;
  for (const std::size_t v : {4U, 3U, 2U, 1U, 0U}) map.push_back(VertexId(v));
  map.push_back(VertexId());
  const TriangleMesh updated = mesh_of(6, {{2, 4, 3}, {5, 2, 1}, {0, 1, 4}});
  const LostTriangles lost = lost_triangles(model, mesh_change(model, updated, map));
  EXPECT_EQ(lost.staying, 3U);
  const std::vector<TriangleId> expected = {TriangleId(std::size_t{1}), TriangleId(std::size_t{2})};
  EXPECT_EQ(lost.lost, expected);
}

TEST(LostTriangles, NoneOfNothing) {
  const LostTriangles lost = lost_triangles({}, mesh_change({}, mesh_of(3, {{0, 1, 2}}), {}));
  EXPECT_EQ(lost.staying, 0U);
  EXPECT_TRUE(lost.lost.empty());
}

// A square cut along its other diagonal is the same surface; one that is bent there is not.
TEST(LostTriangles, AnotherDiagonalIsNotAstray) {
  TriangleMesh model = mesh_of(4, {{0, 1, 2}, {0, 2, 3}});
  const Point corners[] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  std::copy(std::begin(corners), std::end(corners), model.points.begin());
  TriangleMesh updated = model;
  updated.triangles.clear();
  updated.triangles.push_back({VertexId(0U), VertexId(1U), VertexId(3U)});
  updated.triangles.push_back({VertexId(1U), VertexId(2U), VertexId(3U)});
  const std::vector<TriangleId> both = {TriangleId(std::size_t{0}), TriangleId(std::size_t{1})};
  EXPECT_EQ(astray_area(model, both, updated), 0);
  model.points[VertexId(2U)].z = 1;
  EXPECT_NEAR(astray_area(model, both, updated), std::sqrt(2), 1e-12);
  EXPECT_EQ(astray_area(model, both, updated, 0.5), 0);
}

}  // namespace
}  // namespace cocoon
