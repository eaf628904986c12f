#include "update/model/model_index.h"

#include <algorithm>
#include <cstddef>
#include <gtest/gtest.h>
#include <random>
#include <utility>
#include <vector>

#include "tests/mesh_gallery.h"

namespace cocoon {
namespace {

void expect_equal_indexes(const ModelIndex& actual, const ModelIndex& expected) {
  EXPECT_EQ(actual.neighbors().raw(), expected.neighbors().raw());
  for (const VertexId v : expected.mesh().points.ids()) {
    EXPECT_EQ(actual.triangles_at(v), expected.triangles_at(v));
    EXPECT_EQ(actual.is_used(v), expected.is_used(v));
  }
  EXPECT_EQ(actual.is_connected(), expected.is_connected());
  EXPECT_EQ(actual.has_distinct_points(), expected.has_distinct_points());
  for (const TriangleId t : expected.mesh().triangles.ids()) {
    EXPECT_EQ(actual.component(t), expected.component(t));
  }
}

// Two tetrahedra with a facet each towards the other, and the body that has a tunnel's three walls
// between these facets instead of them.
struct Bridge {
  Bridge() {
    for (const double z : {0.0, 1.0}) {
      for (const Point& p : {Point{0, 0, z}, Point{1, 0, z}, Point{0, 1, z}})
        parts.points.push_back(p);
    }
    parts.points.push_back({0.3, 0.3, -1});
    parts.points.push_back({0.3, 0.3, 2});
    const auto add = [](TriangleMesh& mesh, int a, int b, int c) {
      mesh.triangles.push_back({VertexId(a), VertexId(b), VertexId(c)});
    };
    for (TriangleMesh* mesh : {&parts, &joined}) {
      mesh->points = parts.points;
      for (int i = 0; i < 3; ++i) {
        add(*mesh, (i + 1) % 3, i, 6);
        add(*mesh, 3 + i, 3 + (i + 1) % 3, 7);
      }
    }
    add(parts, 0, 1, 2);
    add(parts, 5, 4, 3);
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3;
      add(joined, i, j, 3 + j);
      add(joined, i, 3 + j, 3 + i);
    }
    for (const VertexId v : parts.points.ids()) same.push_back(v);
  }
  TriangleMesh parts;   // two bodies
  TriangleMesh joined;  // one
  IdVector<VertexId, VertexId> same;
};

// In whatever order triangles come, so that many parts meet late.
TEST(ModelIndex, NumbersComponentsByTheirFirstTriangles) {
  constexpr std::size_t count = 3;
  std::vector<std::pair<Triangle, std::size_t>> triangles;  // and the torus that it is of
  TriangleMesh mesh;
  for (std::size_t k = 0; k < count; ++k) {
    const TriangleMesh torus = gallery::torus(17, 9, 3, 1);
    const std::size_t first = mesh.points.size();
    for (const Point& p : torus.points)
      mesh.points.push_back(p + Vec3{10 * static_cast<double>(k), 0, 0});
    for (Triangle t : torus.triangles) {
      for (VertexId& v : t) v = VertexId(first + v.index());
      triangles.emplace_back(t, k);
    }
  }
  std::shuffle(triangles.begin(), triangles.end(), std::mt19937(3));
  for (const auto& [triangle, torus] : triangles) mesh.triangles.push_back(triangle);

  const ModelIndex index(mesh);
  EXPECT_FALSE(index.is_connected());
  std::vector<std::size_t> met;  // tori, as they are met
  for (const TriangleId t : mesh.triangles.ids()) {
    const std::size_t torus = triangles[t.index()].second;
    if (std::find(met.begin(), met.end(), torus) == met.end()) met.push_back(torus);
    ASSERT_EQ(met.at(index.component(t)), torus);
  }
  EXPECT_EQ(met.size(), count);
}

TEST(ModelIndex, AfterAChangeAsFromTheStart) {
  const Bridge bridge;
  const ModelIndex parts(bridge.parts);
  const ModelIndex joined(bridge.joined);
  EXPECT_FALSE(parts.is_connected());
  EXPECT_TRUE(joined.is_connected());
  const MeshChange join = mesh_change(bridge.parts, bridge.joined, bridge.same);
  const MeshChange cut = mesh_change(bridge.joined, bridge.parts, bridge.same);
  expect_equal_indexes(ModelIndex(bridge.joined, {parts, bridge.parts, join}), joined);
  expect_equal_indexes(ModelIndex(bridge.parts, {joined, bridge.joined, cut}), parts);
}

TEST(ModelIndex, ABodyThatComesOrGoes) {
  const Bridge bridge;
  TriangleMesh lower = bridge.parts;
  std::vector<Triangle> kept;
  for (const Triangle& t : bridge.parts.triangles) {
    if (std::max({t[0], t[1], t[2]}) == VertexId(6) || t[2] == VertexId(2)) kept.push_back(t);
  }
  lower.triangles = IdVector<TriangleId, Triangle>(kept);
  const ModelIndex one(lower);
  const ModelIndex both(bridge.parts);
  ASSERT_EQ(kept.size(), 4U);
  ASSERT_TRUE(one.is_connected());
  const MeshChange comes = mesh_change(lower, bridge.parts, bridge.same);
  const MeshChange goes = mesh_change(bridge.parts, lower, bridge.same);
  expect_equal_indexes(ModelIndex(bridge.parts, {one, lower, comes}), both);
  expect_equal_indexes(ModelIndex(lower, {both, bridge.parts, goes}), one);
}

TEST(ModelIndex, TellsWhetherAMeshIsSmooth) {
  const Bridge bridge;
  EXPECT_TRUE(ModelIndex::of_smooth(bridge.joined).is_really_smooth());
  EXPECT_FALSE(ModelIndex::of_smooth(bridge.parts).is_really_smooth());  // two bodies
  TriangleMesh open = bridge.joined;
  open.triangles.raw().pop_back();
  EXPECT_FALSE(ModelIndex::of_smooth(open).is_really_smooth());
  TriangleMesh turned = bridge.joined;
  std::swap(turned.triangles[TriangleId(2)][0], turned.triangles[TriangleId(2)][1]);
  EXPECT_FALSE(ModelIndex::of_smooth(turned).is_really_smooth());
  TriangleMesh pinched = bridge.parts;  // at one vertex
  for (Triangle& t : pinched.triangles) {
    for (VertexId& v : t) v = v == VertexId(7) ? VertexId(6) : v;
  }
  pinched.points.raw().pop_back();
  EXPECT_FALSE(ModelIndex::of_smooth(pinched).is_really_smooth());
}

}  // namespace
}  // namespace cocoon
