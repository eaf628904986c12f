#include "geom/side_links.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <map>
#include <numeric>
#include <utility>

#include "geom/random.h"
#include "tests/mesh_gallery.h"

namespace cocoon {
namespace {

using Edge = std::pair<VertexId, VertexId>;

std::map<Edge, std::vector<SideId>> sides_by_edge(const std::vector<Triangle>& triangles) {
  std::map<Edge, std::vector<SideId>> sides;
  for (SideId side = 0; side < 3 * triangles.size(); ++side) {
    const Triangle& triangle = triangles[triangle_of_side(side)];
    const VertexId a = triangle[next_corner(corner_of_side(side))];
    const VertexId b = triangle[previous_corner(corner_of_side(side))];
    sides[{std::min(a, b), std::max(a, b)}].push_back(side);
  }
  return sides;
}

void expect_rings(const std::vector<Triangle>& triangles, std::size_t num_vertices) {
  for (const int threads : {1, 3}) {
    const SideLinks links = side_links(triangles, num_vertices, {.threads = threads});
    for (const auto& [edge, sides] : sides_by_edge(triangles)) {
      for (std::size_t k = 0; k < sides.size(); ++k) {
        const bool alone = edge.first == edge.second;
        EXPECT_EQ(links[sides[k]], alone ? sides[k] : sides[(k + 1) % sides.size()]);
      }
    }
  }
}

// The triangles that repeat no vertex, by their smallest ones: linked by their groups as by all.
void expect_rings_of_groups(std::vector<Triangle> triangles, std::size_t num_vertices) {
  const auto smallest = [](const Triangle& t) { return std::min({t[0], t[1], t[2]}); };
  std::erase_if(triangles, repeats_a_vertex);
  std::stable_sort(triangles.begin(), triangles.end(),
                   [&](const Triangle& a, const Triangle& b) { return smallest(a) < smallest(b); });
  std::vector<std::uint32_t> begins(num_vertices + 1, 0);
  for (const Triangle& t : triangles) ++begins[smallest(t).index() + 1];
  std::partial_sum(begins.begin(), begins.end(), begins.begin());
  const SideLinks expected = side_links(triangles, num_vertices);
  for (const int threads : {1, 2, 3}) {
    EXPECT_EQ(side_links(triangles, begins, {.threads = threads}), expected);
  }
}

TEST(SideLinks, AClosedMeshHasPairs) {
  const TriangleMesh mesh = gallery::torus(9, 7);
  expect_rings(mesh.triangles.raw(), mesh.points.size());
  expect_rings_of_groups(mesh.triangles.raw(), mesh.points.size());
  const SideLinks links = side_links(mesh.triangles.span(), mesh.points.size());
  for (SideId side = 0; side < links.size(); ++side) {
    EXPECT_NE(links[side], side);
    EXPECT_EQ(links[links[side]], side);
  }
}

TEST(SideLinks, RubbishMakesRingsOfAnyLength) {
  Random random(11);
  std::vector<Triangle> triangles;
  for (int k = 0; k < 3000; ++k) {
    const auto any = [&] { return VertexId(static_cast<std::uint32_t>(random.uniform(0, 40))); };
    triangles.push_back({any(), any(), any()});  // some repeat a vertex
  }
  expect_rings(triangles, 40);
  expect_rings_of_groups(triangles, 40);
}

TEST(SideLinks, AVertexOfGreatValence) {
  std::vector<Triangle> triangles;
  for (std::uint32_t k = 1; k <= 5000; ++k) {
    triangles.push_back({VertexId(0), VertexId(k), VertexId(k % 5000 + 1)});
  }
  expect_rings(triangles, 5001);
  expect_rings_of_groups(triangles, 5001);
}

}  // namespace
}  // namespace cocoon
