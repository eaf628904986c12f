#include "update/cloud/trim_long_edges.h"

#include <algorithm>
#include <array>
#include <gtest/gtest.h>
#include <map>
#include <set>
#include <vector>

#include "geom/arrays/median.h"
#include "geom/random/random.h"
#include "tests/update/hand_made_models.h"

namespace cocoon {
namespace {

// Two sheets of 10 x 10 cells side by side, bridged over a slot of the given width.
TriangleMesh bridged_slot(double width) {
  TriangleMesh mesh = testing::grid_plane(10);
  const std::size_t vertices = mesh.points.size();
  const TriangleMesh other = testing::grid_plane(10);
  for (const Point& p : other.points) mesh.points.push_back(p + Vec3{10 + width, 0, 0});
  for (Triangle t : other.triangles) {
    for (VertexId& v : t) v = VertexId(v.index() + vertices);
    mesh.triangles.push_back(t);
  }
  for (std::size_t y = 0; y < 10; ++y) {
    const VertexId a = testing::vertex(11 * y + 10);
    const VertexId b = testing::vertex(11 * (y + 1) + 10);
    const VertexId c = testing::vertex(vertices + 11 * y);
    const VertexId d = testing::vertex(vertices + 11 * (y + 1));
    mesh.triangles.push_back({a, c, d});
    mesh.triangles.push_back({a, d, b});
  }
  return mesh;
}

TEST(TrimLongEdges, OpensABridgedSlot) {
  const TrimmedSurface wide = trim_long_edges(bridged_slot(8));
  EXPECT_EQ(wide.at_rim + wide.in_clusters, 20U);
  EXPECT_EQ(wide.mesh.triangles.size(), 400U);
  const TrimmedSurface narrow = trim_long_edges(bridged_slot(3));
  EXPECT_EQ(narrow.at_rim + narrow.in_clusters, 0U);
  EXPECT_EQ(trim_long_edges(bridged_slot(8), {.max_edge = 0}).mesh.triangles.size(), 420U);
}

TEST(TrimLongEdges, FromTheRimInwardsIfClustersAreOff) {
  const TrimmedSurface trimmed = trim_long_edges(bridged_slot(8), {.min_cluster = 1000});
  EXPECT_EQ(trimmed.in_clusters, 0U);
  EXPECT_EQ(trimmed.at_rim, 20U);
}

// A hole of 12 cells bridged by triangles that do not reach any rim.
TEST(TrimLongEdges, OpensABridgedHole) {
  TriangleMesh mesh = testing::with_hole(testing::grid_plane(30), 9, 21);
  const std::size_t kept = mesh.triangles.size();
  auto at = [](std::size_t x, std::size_t y) { return testing::vertex(31 * y + x); };
  // Two fans: from one corner of the hole along the two opposite sides.
  for (std::size_t k = 9; k < 21; ++k) {
    mesh.triangles.push_back({at(9, 9), at(21, k), at(21, k + 1)});
    mesh.triangles.push_back({at(9, 9), at(k + 1, 21), at(k, 21)});
  }
  const TrimmedSurface trimmed = trim_long_edges(mesh);
  EXPECT_EQ(trimmed.in_clusters, 24U);
  EXPECT_EQ(trimmed.mesh.triangles.size(), kept);
}

// A tent over a cell: all its edges to the top are long, and none of its triangles is at a rim.
TEST(TrimLongEdges, WhatNoRimIsAtStaysIfClustersAreOff) {
  TriangleMesh mesh = testing::grid_plane(10);
  const VertexId top = mesh.points.push_back({4.5, 4.5, 9});
  IdVector<TriangleId, Triangle> triangles;
  for (const Triangle& t : mesh.triangles) {
    const Point c = (mesh.points[t[0]] + mesh.points[t[1]] + mesh.points[t[2]]) / 3;
    if (distance(c, {4.5, 4.5, 0}) > 0.5) triangles.push_back(t);
  }
  const std::array<VertexId, 4> base = {testing::vertex(4 * 11 + 4), testing::vertex(4 * 11 + 5),
                                        testing::vertex(5 * 11 + 5), testing::vertex(5 * 11 + 4)};
  for (std::size_t k = 0; k < 4; ++k) triangles.push_back({base[k], base[(k + 1) % 4], top});
  ASSERT_EQ(triangles.size(), 202U);
  mesh.triangles = triangles;
  EXPECT_EQ(trim_long_edges(mesh, {.max_edge = 3, .min_cluster = 4}).in_clusters, 4U);
  EXPECT_EQ(trim_long_edges(mesh, {.max_edge = 3, .min_cluster = 5}).mesh.triangles, triangles);
}

// Neither are they long, however far their corners are, nor do they make others so.
TEST(TrimLongEdges, TrianglesThatRepeatAVertexDoNotMatter) {
  Random random(9);
  TriangleMesh mesh = testing::grid_plane(12);
  for (Point& p : mesh.points) p = p + random.uniform(0, 0.5) * random.on_unit_sphere();
  const TrimOptions options{.max_edge = 2, .min_cluster = 1};
  TriangleMesh expected = trim_long_edges(mesh, options).mesh;
  EXPECT_LT(expected.triangles.size(), mesh.triangles.size());
  std::vector<Triangle> added;
  const std::size_t count = mesh.points.size();
  for (std::size_t i = 0; i < count; ++i) {
    const VertexId v(i);
    added.push_back({v, v, VertexId(count - 1)});
    for (int k = 1; k <= 9; ++k) {  // close to v
      const VertexId near = mesh.points.push_back(mesh.points[v] + Vec3{0, 0, 1e-6 * k});
      added.push_back({v, near, near});
    }
  }
  for (const Triangle& t : added) {
    mesh.triangles.push_back(t);
    expected.triangles.push_back(t);
  }
  EXPECT_EQ(trim_long_edges(mesh, options).mesh.triangles, expected.triangles);
}

// Two triangles at the rim; the long edge of the inner one is open once the outer one has gone.
TEST(TrimLongEdges, GoesOnFromTheRimInwards) {
  const TriangleMesh plane = testing::grid_plane(12);
  const auto at = [](std::size_t y) { return VertexId(y * 13 + 12); };
  for (const bool outer_first : {true, false}) {
    TriangleMesh mesh = plane;
    const VertexId far = mesh.points.push_back({18, 6, 0});
    std::vector<Triangle> added = {{at(9), at(3), far}, {at(3), at(9), at(6)}};
    if (!outer_first) std::swap(added[0], added[1]);
    for (const Triangle& t : added) mesh.triangles.push_back(t);
    const TrimmedSurface trimmed = trim_long_edges(mesh);
    EXPECT_EQ(trimmed.mesh.triangles, plane.triangles);
    EXPECT_EQ(trimmed.at_rim, 2U);
    EXPECT_EQ(trimmed.in_clusters, 0U);
  }
}

TEST(TrimLongEdges, KeepsAnEvenSurface) {
  for (const TriangleMesh& mesh : {testing::sphere(4), testing::grid_plane(12)}) {
    EXPECT_EQ(trim_long_edges(mesh).mesh.triangles, mesh.triangles);
  }
  EXPECT_TRUE(trim_long_edges({}).mesh.triangles.empty());
}

// The triangles without a long edge, by the definition.
IdVector<TriangleId, Triangle> without_long_edges(const TriangleMesh& mesh, double max_edge) {
  std::map<VertexId, std::set<VertexId>> around;
  for (const Triangle& t : mesh.triangles) {
    for (const VertexId v : t) around[v].insert(t.begin(), t.end());
  }
  std::map<VertexId, double> quartiles;
  const auto length = [&](VertexId a, VertexId b) {
    return distance(mesh.points[a], mesh.points[b]);
  };
  for (auto& [v, others] : around) {
    others.erase(v);
    std::vector<double> lengths;
    for (const VertexId w : others) lengths.push_back(length(v, w));
    quartiles[v] = quantile_in_place(lengths, 0.25);
  }
  const auto spacing = [&](VertexId v) {
    std::vector<double> numbers{quartiles[v]};
    for (const VertexId w : around[v]) numbers.push_back(quartiles[w]);
    return median(numbers);
  };
  const auto is_long = [&](VertexId a, VertexId b) {
    return length(a, b) > max_edge * std::min(spacing(a), spacing(b));
  };
  IdVector<TriangleId, Triangle> kept;
  for (const Triangle& t : mesh.triangles) {
    if (is_long(t[0], t[1]) || is_long(t[1], t[2]) || is_long(t[2], t[0])) continue;
    kept.push_back(t);
  }
  return kept;
}

TEST(TrimLongEdges, WhatIsLongIsAsDefined) {
  Random random(8);
  std::size_t removed = 0;
  for (const double jitter : {0.2, 0.5, 2.0}) {
    TriangleMesh mesh = testing::grid_plane(12);
    for (Point& p : mesh.points) p = p + random.uniform(0, jitter) * random.on_unit_sphere();
    for (const double max_edge : {1.2, 2.0, 5.0}) {
      const TrimmedSurface trimmed =
          trim_long_edges(mesh, {.max_edge = max_edge, .min_cluster = 1});
      EXPECT_EQ(trimmed.mesh.triangles, without_long_edges(mesh, max_edge));
      EXPECT_EQ(trimmed.rings.links, link_halfedges(trimmed.mesh).links);
      removed += trimmed.in_clusters;
    }
  }
  EXPECT_GT(removed, 100U);
}

}  // namespace
}  // namespace cocoon
