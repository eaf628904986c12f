#include "delaunay/star_cache.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "delaunay/delaunay.h"
#include "tests/gallery.h"

namespace cocoon {
namespace {

std::vector<CellId> copy(std::span<const CellId> cells) { return {cells.begin(), cells.end()}; }

TEST(StarCache, StarsAreThoseListedAtOnceWhetherAnnouncedOrNot) {
  const Triangulation triangulation = delaunay(gallery::bumpy_sphere(20000)).triangulation;
  const VertexStars expected = vertex_stars(triangulation);
  for (const int threads : {1, 3}) {
    const Execution execution{.threads = threads};
    const VertexStars listed = vertex_stars(triangulation, execution);
    StarCache asked(triangulation, execution);
    EXPECT_FALSE(asked.expect(10));
    StarCache announced(triangulation, execution);
    EXPECT_TRUE(announced.expect(triangulation.num_vertices()));
    const std::span<const CellId> first = asked.star(VertexId(0));
    const std::vector<CellId> first_before = copy(first);
    for (const VertexId v : triangulation.vertices()) {
      const std::vector<CellId> star = copy(expected.star(v));
      ASSERT_TRUE(std::is_sorted(star.begin(), star.end()));
      ASSERT_EQ(copy(listed.star(v)), star);
      ASSERT_EQ(copy(asked.star(v)), star);
      ASSERT_EQ(copy(announced.star(v)), star);
    }
    EXPECT_TRUE(asked.expect(0));  // so many were asked for that all are listed
    EXPECT_EQ(copy(first), first_before);
  }
}

TEST(StarCache, CellsAtFewOrManyVertices) {
  const Triangulation triangulation = delaunay(gallery::bumpy_sphere(20000)).triangulation;
  for (const std::uint32_t every : {997U, 3U}) {
    std::vector<VertexId> asked;
    for (const VertexId v : triangulation.vertices()) {
      if (v.value % every == 0) asked.push_back(v);
    }
    std::vector<CellId> expected;
    for (const CellId c : triangulation.cells()) {
      const auto& vertices = triangulation.cell(c).vertices;
      const bool has_one = std::any_of(vertices.begin(), vertices.end(), [&](VertexId v) {
        return v != infinite_vertex && v.value % every == 0;
      });
      if (has_one) expected.push_back(c);
    }
    EXPECT_EQ(StarCache(triangulation).cells_at(asked), expected);
  }
}

// Some points inside, far from the surface, have many of the cells: soon all stars are listed.
TEST(StarCache, FewVerticesWithManyCells) {
  std::vector<Point> points = gallery::bumpy_sphere(20000);
  for (int k = 0; k < 1300; ++k) points.push_back({std::cos(k) / 4, std::sin(k) / 4, 0.00015 * k});
  const Triangulation triangulation = delaunay(points).triangulation;
  std::vector<VertexId> inside;
  std::vector<CellId> expected;
  for (const VertexId v : triangulation.vertices()) {
    if (squared_norm(triangulation.point(v)) < 0.25) inside.push_back(v);
  }
  ASSERT_EQ(inside.size(), 1300U);
  std::size_t cells_of_stars = 0;
  for (const CellId c : triangulation.cells()) {
    const auto& vertices = triangulation.cell(c).vertices;
    const auto corners = std::count_if(vertices.begin(), vertices.end(), [&](VertexId v) {
      return std::find(inside.begin(), inside.end(), v) != inside.end();
    });
    if (corners > 0) expected.push_back(c);
    cells_of_stars += static_cast<std::size_t>(corners);
  }
  EXPECT_GT(3 * cells_of_stars, triangulation.num_cells() + 1024);
  StarCache stars(triangulation);
  EXPECT_FALSE(stars.expect(inside.size()));
  EXPECT_EQ(stars.cells_at(inside), expected);
  EXPECT_TRUE(stars.expect(inside.size()));
}

}  // namespace
}  // namespace cocoon
