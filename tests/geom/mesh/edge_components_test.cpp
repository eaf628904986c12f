#include "geom/mesh/edge_components.h"

#include <cstdint>
#include <gtest/gtest.h>
#include <utility>
#include <vector>

#include "geom/mesh/halfedges.h"
#include "geom/random/random.h"
#include "geom/triangle_mesh.h"

namespace cocoon {
namespace {

// What it should be, from triangle to triangle: its first one tells how a component runs.
EdgeComponents flooded(const TriangleMesh& mesh, const HalfedgeRings& rings) {
  const auto none = static_cast<std::uint32_t>(-1);
  EdgeComponents result;
  result.component_of.assign(mesh.triangles.size(), none);
  result.turned.assign(mesh.triangles.size(), 0);
  for (std::uint32_t first = 0; first < mesh.triangles.size(); ++first) {
    if (result.component_of[first] != none) continue;
    const auto number = static_cast<std::uint32_t>(result.components.size());
    EdgeComponent component;
    std::vector<std::uint32_t> stack{first};
    result.component_of[first] = number;
    while (!stack.empty()) {
      const std::uint32_t t = stack.back();
      stack.pop_back();
      ++component.triangles;
      component.turned += result.turned[t];
      for (Halfedge halfedge = 3 * t; halfedge < 3 * t + 3; ++halfedge) {
        if (!rings.has_two_triangles(halfedge)) continue;
        const Halfedge across = rings.links[halfedge];
        const std::uint32_t next = triangle_of_halfedge(across);
        const bool disagree =
            ends_of_halfedge(mesh, halfedge)[0] == ends_of_halfedge(mesh, across)[0];
        const auto turned = static_cast<std::uint8_t>(result.turned[t] ^ (disagree ? 1U : 0U));
        if (result.component_of[next] == none) {
          result.component_of[next] = number;
          result.turned[next] = turned;
          stack.push_back(next);
        } else if (result.turned[next] != turned) {
          component.is_contradictory = true;
        }
      }
    }
    result.components.push_back(component);
  }
  return result;
}

void expect_equal(const EdgeComponents& found, const EdgeComponents& expected) {
  ASSERT_EQ(found.component_of, expected.component_of);
  ASSERT_EQ(found.components.size(), expected.components.size());
  for (std::size_t k = 0; k < found.components.size(); ++k) {
    SCOPED_TRACE(k);
    EXPECT_EQ(found.components[k].triangles, expected.components[k].triangles);
    ASSERT_EQ(found.components[k].is_contradictory, expected.components[k].is_contradictory);
    if (expected.components[k].is_contradictory) continue;
    EXPECT_EQ(found.components[k].turned, expected.components[k].turned);
  }
  for (std::size_t t = 0; t < found.turned.size(); ++t) {
    if (expected.components[expected.component_of[t]].is_contradictory) continue;
    ASSERT_EQ(found.turned[t], expected.turned[t]) << t;
  }
}

void expect_as_flooded(const TriangleMesh& mesh) {
  const HalfedgeRings rings = link_halfedges(mesh);
  const EdgeComponents expected = flooded(mesh, rings);
  for (const int threads : {1, 3}) {
    SCOPED_TRACE(threads);
    expect_equal(edge_components(mesh, rings, Execution{.threads = threads}), expected);
  }
}

// n x m squares of two triangles each; with `twist` the last column meets the first one upside
// down, as in a Moebius strip. Triangles are turned and left out at random.
TriangleMesh strip(std::uint32_t n, std::uint32_t m, bool twist, double missing, Random& random) {
  TriangleMesh mesh;
  for (std::uint32_t i = 0; i < n * (m + 1); ++i) mesh.points.push_back({1.0 * i, 0, 0});
  const auto vertex = [&](std::uint32_t column, std::uint32_t row) {
    if (column == n && twist) row = m - row;
    return VertexId(column % n * (m + 1) + row);
  };
  const auto add = [&](Triangle triangle) {
    if (random.uniform(0, 1) < missing) return;
    if (random.uniform(0, 1) < 0.5) std::swap(triangle[1], triangle[2]);
    mesh.triangles.push_back(triangle);
  };
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t j = 0; j < m; ++j) {
      add({vertex(i, j), vertex(i + 1, j), vertex(i, j + 1)});
      add({vertex(i, j + 1), vertex(i + 1, j), vertex(i + 1, j + 1)});
    }
  }
  return mesh;
}

TEST(EdgeComponents, RingsMoebiusStripsAndCrumbs) {
  Random random(1);
  for (std::uint32_t k = 0; k < 40; ++k) {
    expect_as_flooded(strip(5 + k % 7, 1 + k % 4, k % 2 == 1, 0.1 * (k % 5), random));
  }
}

TEST(EdgeComponents, OfManyChunks) {
  Random random(2);
  expect_as_flooded(strip(300, 200, false, 0, random));
  expect_as_flooded(strip(300, 200, true, 0, random));
  expect_as_flooded(strip(300, 200, true, 0.35, random));
}

// Three triangles on an edge, a triangle twice, and one that repeats a vertex.
TEST(EdgeComponents, IrregularEdgesConnectNothing) {
  TriangleMesh mesh;
  for (int i = 0; i < 6; ++i) mesh.points.push_back({1.0 * i, 0, 0});
  const auto add = [&](int a, int b, int c) {
    mesh.triangles.push_back({VertexId(a), VertexId(b), VertexId(c)});
  };
  add(0, 1, 2);
  add(0, 1, 3);
  add(1, 0, 4);
  add(2, 3, 4);
  add(4, 3, 2);
  add(5, 5, 2);
  expect_as_flooded(mesh);
  const HalfedgeRings rings = link_halfedges(mesh);
  EXPECT_EQ(edge_components(mesh, rings).components.size(), 5U);
}

TEST(EdgeComponents, NoTriangles) { expect_as_flooded({}); }

}  // namespace
}  // namespace cocoon
