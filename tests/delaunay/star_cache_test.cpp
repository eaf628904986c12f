#include "delaunay/star_cache.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <vector>

#include "delaunay/delaunay.h"
#include "tests/gallery.h"

namespace cocoon {
namespace {

std::vector<CellId> sorted(std::span<const CellId> cells) {
  std::vector<CellId> list(cells.begin(), cells.end());
  std::sort(list.begin(), list.end());
  return list;
}

TEST(StarCache, StarsAreThoseListedAtOnceWhetherAnnouncedOrNot) {
  const Triangulation triangulation = delaunay(gallery::bumpy_sphere(20000)).triangulation;
  const VertexStars expected = vertex_stars(triangulation);
  StarCache asked(triangulation);
  EXPECT_FALSE(asked.expect(10));
  StarCache announced(triangulation);
  EXPECT_TRUE(announced.expect(triangulation.num_vertices()));
  for (const VertexId v : triangulation.vertices()) {
    const std::vector<CellId> star = sorted(expected.star(v));
    ASSERT_EQ(sorted(asked.star(v)), star);
    ASSERT_EQ(sorted(announced.star(v)), star);
  }
  EXPECT_TRUE(asked.expect(0));  // so many were asked for that all are listed
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

}  // namespace
}  // namespace cocoon
