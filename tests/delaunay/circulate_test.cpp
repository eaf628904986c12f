#include "delaunay/circulate.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <set>
#include <vector>

#include "delaunay/vertex_stars.h"
#include "ref/cgal_delaunay.h"
#include "tests/gallery.h"

namespace cocoon {
namespace {

bool facet_has(const Triangulation& triangulation, FacetId f, VertexId v) {
  const auto corners = triangulation.facet_vertices(f);
  return std::find(corners.begin(), corners.end(), v) != corners.end();
}

// One tetrahedron: around the edge 0-1 lie the facets 01-2, 01-3 and 01-infinity.
TEST(Circulate, EdgeOfOneTetrahedronHasThreeFacets) {
  const std::vector<Point> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const Triangulation triangulation = ref::cgal_delaunay(points);
  const VertexId a = triangulation.vertex(CellId(0), 0);
  const VertexId b = triangulation.vertex(CellId(0), 1);
  std::set<VertexId> third;
  int count = 0;
  for_each_facet_around_edge(triangulation, facet_id(CellId(0), 2), a, b, [&](FacetId f) {
    third.insert(third_vertex(triangulation, f, a, b));
    ++count;
  });
  EXPECT_EQ(count, 3);
  EXPECT_EQ(third, (std::set<VertexId>{triangulation.vertex(CellId(0), 2),
                                       triangulation.vertex(CellId(0), 3), infinite_vertex}));
}

// Against a search through all facets, for every edge of every cell.
TEST(Circulate, EdgeRotationVisitsEveryFacetAtTheEdgeOnce) {
  const Triangulation triangulation = ref::cgal_delaunay(gallery::uniform_cube(25));
  for (const CellId c : triangulation.finite_cells()) {
    for (int i = 0; i < 4; ++i) {
      const FacetId start = facet_id(c, i);
      const auto [a, b, apex] = triangulation.facet_vertices(start);
      std::vector<FacetId> expected;
      for (const CellId d : triangulation.cells()) {
        for (int j = 0; j < 4; ++j) {
          const FacetId f = facet_id(d, j);
          if (triangulation.canonical(f) == f && facet_has(triangulation, f, a) &&
              facet_has(triangulation, f, b)) {
            expected.push_back(f);
          }
        }
      }
      std::vector<FacetId> visited;
      std::vector<CellId> cells;
      for_each_facet_around_edge(triangulation, start, a, b, [&, x = a, y = b](FacetId f) {
        EXPECT_TRUE(has_vertex(triangulation.cell(cell_of(f)), x));
        EXPECT_TRUE(has_vertex(triangulation.cell(cell_of(f)), y));
        visited.push_back(triangulation.canonical(f));
        cells.push_back(cell_of(f));
      });
      EXPECT_EQ(triangulation.canonical(start), visited.front());
      EXPECT_EQ(third_vertex(triangulation, start, a, b), apex);
      std::sort(visited.begin(), visited.end());
      EXPECT_EQ(visited, expected);
      std::sort(cells.begin(), cells.end());
      EXPECT_EQ(std::adjacent_find(cells.begin(), cells.end()), cells.end());
    }
  }
}

TEST(Circulate, StarsHoldExactlyTheCellsOfAVertexInOrder) {
  const Triangulation triangulation = ref::cgal_delaunay(gallery::uniform_cube(60));
  const VertexStars stars = vertex_stars(triangulation);
  for (const VertexId v : triangulation.vertices()) {
    std::vector<CellId> expected;
    bool on_hull = false;
    for (const CellId c : triangulation.cells()) {
      if (!has_vertex(triangulation.cell(c), v)) continue;
      expected.push_back(c);
      on_hull |= triangulation.is_infinite(c);
      EXPECT_EQ(triangulation.vertex(c, index_of_vertex(triangulation.cell(c), v)), v);
    }
    const auto star = stars.star(v);
    EXPECT_EQ(std::vector<CellId>(star.begin(), star.end()), expected);
    EXPECT_EQ(is_hull_vertex(triangulation, stars, v), on_hull);
  }
}

TEST(Circulate, FacetsAroundAVertexComeOnceEach) {
  const Triangulation triangulation = ref::cgal_delaunay(gallery::uniform_cube(40));
  const VertexStars stars = vertex_stars(triangulation);
  for (const VertexId v : triangulation.vertices()) {
    std::vector<FacetId> visited;
    for_each_facet_around_vertex(triangulation, stars, v, [&](FacetId f) { visited.push_back(f); });
    std::vector<FacetId> expected;
    for (const CellId c : triangulation.cells()) {
      for (int i = 0; i < 4; ++i) {
        const FacetId f = facet_id(c, i);
        if (triangulation.canonical(f) == f && facet_has(triangulation, f, v)) {
          expected.push_back(f);
        }
      }
    }
    std::sort(visited.begin(), visited.end());
    EXPECT_EQ(visited, expected);
  }
}

}  // namespace
}  // namespace cocoon
