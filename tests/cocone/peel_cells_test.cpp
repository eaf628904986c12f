#include "cocone/peel_cells.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <gtest/gtest.h>
#include <utility>
#include <vector>

#include "cocone/facets/linked_facets.h"
#include "cocone/surface_mesh.h"
#include "delaunay/circulate.h"
#include "delaunay/delaunay.h"
#include "tests/cocone/marked.h"
#include "tests/cocone/octahedron.h"
#include "tests/cocone/sample_shapes.h"

namespace cocoon {
namespace {

// Nothing is good, and all finite cells are IN.
CellMarks all_in(const Triangulation& t) {
  CellMarks marks;
  marks.labels = IdVector<CellId, CellLabel>(t.num_cells(), CellLabel::in);
  for (const CellId c : t.infinite_cells()) marks.labels[c] = CellLabel::out;
  marks.good = VertexSet(t.num_vertices(), 0);
  marks.visited = marks.good;
  return marks;
}

// A pit over an equilateral triangle on the hull, whose circle has radius 1: a cell with an apex
// at this height, all around it is IN. If the apex is high the triangle is the smallest facet of
// the cell and closes the pit, else it is reached.
TEST(PeelCells, StopsAtTheSmallestFacetOfAPoorCell) {
  for (const double height : {2.0, 0.5}) {
    const double root = std::sqrt(0.75);
    const std::vector<Point> points = {{0, 1, 0},          {-root, -0.5, 0}, {root, -0.5, 0},
                                       {0, 0, height},     {0, -3, 2},       {3 * root, 1.5, 2},
                                       {-3 * root, 1.5, 2}};
    const Triangulation t = delaunay(points).triangulation;
    CellMarks marks = all_in(t);
    CellId pit;
    for (const CellId c : t.finite_cells()) {
      const auto& vertices = t.cell(c).vertices;
      const bool is_pit = std::all_of(vertices.begin(), vertices.end(),
                                      [&](VertexId v) { return t.point_of_vertex(v).index() < 4; });
      if (is_pit) pit = c;
    }
    ASSERT_FALSE(pit.is_none());
    marks.labels[pit] = CellLabel::unmarked;
    for (const std::size_t rounds : {0U, 1U}) {
      marks.rounds = rounds;
      const CellMarks peeled = peel_cells(t, FacetSet(t.num_cells()), marks);
      EXPECT_EQ(peeled.poor_cells, 1U);
      for (const CellId c : t.finite_cells()) {
        EXPECT_EQ(peeled.reached[c] != 0, c == pit && height < 1) << height;
      }
      for (const CellId c : t.infinite_cells()) EXPECT_EQ(peeled.reached[c], 1);
    }
  }
}

// A vertex that is not contradicted has one side OUT and the other one not.
TEST(PeelCells, TellsTheVerticesThatAreContradicted) {
  const Marked m(shapes::noisy_sphere(3000, 0.03, 5));
  const CellMarks peeled = peel_cells(m.s.triangulation, m.surface, m.marks);
  const Triangulation& t = m.s.triangulation;
  ASSERT_FALSE(peeled.contradicted.empty());
  std::size_t count = 0;
  for (const VertexId v : t.vertices()) {
    if (peeled.good[v] == 0) continue;
    bool fits = true;
    for_each_facet_around_vertex(t, m.s.stars, v, [&](FacetId f) {
      const bool differ = (peeled.labels[cell_of(f)] == CellLabel::out) !=
                          (peeled.labels[t.neighbor(cell_of(f), index_of(f))] == CellLabel::out);
      fits = fits && differ == m.surface.contains(f);
    });
    EXPECT_EQ(peeled.contradicted[v] == 0, fits);
    count += fits ? 0U : 1U;
  }
  EXPECT_GT(count, 0U);
  const Marked clean(shapes::random_torus(2500, 0.4, 1));
  EXPECT_TRUE(peel_cells(clean.s.triangulation, clean.surface, clean.marks).contradicted.empty());
}

TEST(PeelCells, WithoutASurfaceEverythingIsPoor) {
  // No surface: all vertices are poor, all finite cells poor cells, and nothing is IN.
  const Stages s(shapes::sphere(300, 7));
  const FacetSet nothing(s.triangulation.num_cells());
  const VertexSet all_boundary(s.triangulation.num_vertices(), 1);
  CellMarks marks =
      mark_cells(s.triangulation, link_facets(s.triangulation, nothing), all_boundary);
  EXPECT_EQ(marks.good_vertices, 0U);
  marks = peel_cells(s.triangulation, nothing, std::move(marks));
  EXPECT_EQ(marks.poor_cells, s.triangulation.num_finite_cells());
  for (const CellId c : s.triangulation.cells()) EXPECT_NE(marks.labels[c], CellLabel::in);
}

TEST(PeelCells, TheBodyOfACleanSurfaceIsWhatWasMarkedIn) {
  const Marked m(shapes::random_torus(2000, 0.4, 8));
  const CellMarks peeled = peel_cells(m.s.triangulation, m.surface, m.marks);
  for (const CellId c : m.s.triangulation.cells()) {
    EXPECT_EQ(peeled.reached[c] != 0, m.marks.labels[c] == CellLabel::out);
  }
  EXPECT_EQ(surface_between(m.s.triangulation, peeled).mesh.triangles.size(), m.surface.size());
}

// What is known to be OUT around the center of an octahedron, cell by cell.
TEST(OpenCavities, ReachesWhatIsKnownToBeOutInside) {
  const Octahedron o;
  const Triangulation& t = o.triangulation;
  const auto opened = [&](std::vector<CellId> hollow) {
    CellMarks marks = peel_cells(t, FacetSet(t.num_cells()), all_in(t));
    marks.known = IdVector<CellId, CellLabel>(t.num_cells(), CellLabel::unmarked);
    for (const CellId c : hollow) marks.known[c] = CellLabel::out;
    const CavityCounters counters = open_cavities(t, FacetSet(t.num_cells()), marks);
    for (const CellId c : t.finite_cells()) {
      const bool is_hollow = std::find(hollow.begin(), hollow.end(), c) != hollow.end();
      EXPECT_EQ(marks.reached[c] != 0, is_hollow);
      EXPECT_EQ(marks.labels[c], is_hollow ? CellLabel::out : CellLabel::in);
    }
    EXPECT_EQ(counters.cells, hollow.size());
    return counters.cavities;
  };
  const CellId first(0);
  EXPECT_EQ(opened({}), 0U);
  EXPECT_EQ(opened({first}), 1U);
  for (const CellId other : t.finite_cells()) {
    if (other == first) continue;
    bool is_beside = false;
    for (int i = 0; i < 4; ++i) is_beside |= t.neighbor(first, i) == other;
    EXPECT_EQ(opened({first, other}), is_beside ? 1U : 2U);
  }
}

// Of two spheres, one in the other: the inner one bounds a cavity.
TEST(OpenCavities, BeginsAtGoodVerticesThatNobodyVisited) {
  const Marked m(shapes::joined(shapes::sphere(1200, 3), shapes::sphere(500, 4, 0.4)));
  CellMarks marks = peel_cells(m.s.triangulation, m.surface, m.marks);
  const std::size_t before = surface_between(m.s.triangulation, marks).mesh.triangles.size();
  EXPECT_EQ(before, 2U * 1200 - 4);
  const CavityCounters counters = open_cavities(m.s.triangulation, m.surface, marks);
  EXPECT_EQ(counters.cavities, 1U);
  EXPECT_GT(counters.cells, 500U);
  EXPECT_EQ(surface_between(m.s.triangulation, marks).mesh.triangles.size(), before + 2 * 500 - 4);
}

}  // namespace
}  // namespace cocoon
