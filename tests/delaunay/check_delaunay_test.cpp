// The certificate accepts what is right, and each of its tests rejects what it is there for.
#include "delaunay/check_delaunay.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <utility>
#include <vector>

#include "delaunay/circulate.h"
#include "geom/errors.h"
#include "geom/orient3d.h"
#include "ref/brute_force_delaunay.h"
#include "ref/cell_set.h"
#include "ref/cgal_delaunay.h"
#include "ref/triangulation_of_cells.h"
#include "tests/gallery.h"

namespace cocoon {
namespace {

using CellList = std::vector<std::array<VertexId, 4>>;

// A copy with the given cell records.
Triangulation with_cells(const Triangulation& triangulation, IdVector<CellId, Cell> cells) {
  return Triangulation({triangulation.points(), std::move(cells), triangulation.vertex_of_point()},
                       triangulation.num_finite_cells());
}

// The triangulation of all but one finite cell.
Triangulation without_cell(const std::vector<Point>& points, CellId removed) {
  const Triangulation triangulation = ref::cgal_delaunay(points);
  CellList cells;
  for (const CellId c : triangulation.finite_cells()) {
    if (c != removed) cells.push_back(triangulation.cell(c).vertices);
  }
  return ref::triangulation_of_cells(ref::distinct_points(points), cells);
}

TEST(CheckDelaunay, AcceptsTheOracleOnGenericAndDegenerateSets) {
  using namespace gallery;
  for (const auto& points :
       {uniform_cube(2000), sphere(2000), integer_grid(9), integer_sphere(1105), box_faces(6),
        plane_and_apex(12), cylinder(5), two_lines(20), ulp_pairs(500), displaced_torus(3000),
        clusters(1000), shifted(uniform_cube(1000), {1e7, 1e7, 1e7})}) {
    const Triangulation triangulation = ref::cgal_delaunay(points);
    const DelaunayReport report = check_delaunay(triangulation, {.threads = 2});
    EXPECT_TRUE(report.ok()) << report.first_violation;
    if (triangulation.num_vertices() > 600) continue;
    EXPECT_EQ(ref::occupied_pairs(triangulation), 0U);
  }
}

TEST(CheckDelaunay, RejectsAnEmptyTriangulation) { EXPECT_FALSE(check_delaunay({}).ok()); }

TEST(CheckDelaunay, FindsAWrongSetOfVertices) {
  const Triangulation good = ref::cgal_delaunay(gallery::uniform_cube(50));
  const VertexId out_of_range(good.num_vertices());
  for (const VertexId bad :
       {out_of_range, VertexId(), infinite_vertex, good.vertex(CellId(3), 0)}) {
    IdVector<CellId, Cell> cells = good.cell_records();
    cells[CellId(3)].vertices[2] = bad;
    EXPECT_EQ(check_delaunay(with_cells(good, cells)).malformed_cells, 1U);
  }
  IdVector<CellId, Cell> cells = good.cell_records();
  auto& infinite = cells[CellId(good.num_finite_cells() + 1)].vertices;
  std::swap(infinite[2], infinite[3]);
  const DelaunayReport report = check_delaunay(with_cells(good, cells));
  EXPECT_EQ(report.malformed_cells, 1U);
  EXPECT_FALSE(report.ok());
}

TEST(CheckDelaunay, FindsABrokenNeighbor) {
  const Triangulation good = ref::cgal_delaunay(gallery::uniform_cube(50));
  for (const FacetId bad : {FacetId(), FacetId(4 * good.num_cells()), facet_id(CellId(5), 0)}) {
    IdVector<CellId, Cell> cells = good.cell_records();
    cells[CellId(5)].neighbors[1] = bad;
    const DelaunayReport report = check_delaunay(with_cells(good, cells));
    EXPECT_GE(report.broken_neighbors, 1U);
    EXPECT_FALSE(report.ok());
  }
}

TEST(CheckDelaunay, FindsAVertexInNoCell) {
  const Triangulation good = ref::cgal_delaunay(gallery::uniform_cube(50));
  IdVector<VertexId, Point> points = good.points();
  points.push_back({0.5, 0.5, 0.5});
  const Triangulation bad({points, good.cell_records(), good.vertex_of_point()},
                          good.num_finite_cells());
  const DelaunayReport report = check_delaunay(bad);
  EXPECT_EQ(report.unused_vertices, 1U);
  EXPECT_EQ(report.vertices_without_point, 1U);
}

TEST(CheckDelaunay, FindsCellsInsideOut) {
  // A mirror image has the same combinatorics and all cells inside out.
  const Triangulation good = ref::cgal_delaunay(gallery::uniform_cube(50));
  IdVector<VertexId, Point> points = good.points();
  for (Point& p : points) p.x = -p.x;
  const Triangulation bad({points, good.cell_records(), good.vertex_of_point()},
                          good.num_finite_cells());
  const DelaunayReport report = check_delaunay(bad);
  EXPECT_EQ(report.misoriented_cells, good.num_finite_cells());
  EXPECT_GT(report.reflex_hull_edges, 0U);
}

TEST(CheckDelaunay, FindsAMovedVertex) {
  const Triangulation good = ref::cgal_delaunay(gallery::uniform_cube(200));
  IdVector<VertexId, Point> points = good.points();
  points[VertexId(100)] = points[VertexId(20)] + Vec3{1e-3, 0, 0};
  const Triangulation bad({points, good.cell_records(), good.vertex_of_point()},
                          good.num_finite_cells());
  EXPECT_GT(check_delaunay(bad).misoriented_cells, 0U);
}

TEST(CheckDelaunay, FindsAHoleInTheHull) {
  // A hull cell whose fourth vertex is inside: without it the hull has a dent.
  const std::vector<Point> points = gallery::uniform_cube(300);
  const Triangulation good = ref::cgal_delaunay(points);
  const VertexStars stars = vertex_stars(good);
  int dents = 0;
  for (const CellId hull : good.infinite_cells()) {
    const FacetId inner = good.mirror(facet_id(hull, 3));
    if (is_hull_vertex(good, stars, good.opposite_vertex(inner))) continue;
    const DelaunayReport report = check_delaunay(without_cell(points, cell_of(inner)));
    // The three inner edges of the dent, each seen from both sides.
    EXPECT_EQ(report.reflex_hull_edges, 6U);
    EXPECT_EQ(report.occupied_spheres, 0U);
    EXPECT_EQ(report.bad_links, 0U);
    if (++dents == 3) break;
  }
  EXPECT_EQ(dents, 3);
}

TEST(CheckDelaunay, FindsAPinchedVertex) {
  // Two tetrahedra that touch in the origin.
  const std::vector<Point> points{{0, 0, 0},  {1, 0, 0},  {0, 1, 0}, {0, 0, 1},
                                  {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
  const ref::DistinctPoints distinct = ref::distinct_points(points);
  const auto v = [&](int i) { return distinct.vertex_of_point[PointId(i)]; };
  const Triangulation bad =
      ref::triangulation_of_cells(distinct, {{v(0), v(1), v(2), v(3)}, {v(0), v(5), v(4), v(6)}});
  const DelaunayReport report = check_delaunay(bad);
  EXPECT_EQ(report.broken_neighbors, 0U);
  EXPECT_EQ(report.misoriented_cells, 0U);
  EXPECT_EQ(report.bad_links, 2U);  // at the origin and at infinity
}

// Five points have two triangulations, of two and of three cells. One is Delaunay.
TEST(CheckDelaunay, FindsAFacetThatShouldBeFlipped) {
  for (const double height : {0.1, 3.0}) {
    const std::vector<Point> points{
        {1, 0, 0}, {-0.5, 1, 0}, {-0.5, -1, 0}, {0.01, 0, height}, {0, 0.02, -height}};
    const ref::DistinctPoints distinct = ref::distinct_points(points);
    const auto v = [&](int i) { return distinct.vertex_of_point[PointId(i)]; };
    const Triangulation two =
        ref::triangulation_of_cells(distinct, {{v(0), v(1), v(2), v(3)}, {v(0), v(2), v(1), v(4)}});
    const Triangulation three = ref::triangulation_of_cells(
        distinct, {{v(0), v(1), v(4), v(3)}, {v(1), v(2), v(4), v(3)}, {v(2), v(0), v(4), v(3)}});
    const Triangulation& good = height > 1 ? two : three;
    const Triangulation& bad = height > 1 ? three : two;
    EXPECT_TRUE(check_delaunay(good).ok());
    const DelaunayReport report = check_delaunay(bad);
    EXPECT_EQ(report.misoriented_cells, 0U);
    EXPECT_EQ(report.occupied_spheres, height > 1 ? 3U : 1U);
    EXPECT_GT(ref::occupied_pairs(bad), 0U);
  }
}

// The corners of a cube are cospherical: every triangulation is locally Delaunay but for ties, and
// one of them has all ties broken right.
TEST(CheckDelaunay, FindsATieBrokenWrong) {
  const std::vector<Point> points = gallery::integer_grid(2);
  const ref::DistinctPoints distinct = ref::distinct_points(points);
  // The central tetrahedron of corners of equal parity and the four corners cut off by it.
  const auto five_cells = [&](int flip) {
    const auto v = [&](int x, int y, int z) { return VertexId(4 * (x ^ flip) + 2 * y + z); };
    CellList cells{{v(0, 0, 0), v(1, 1, 0), v(1, 0, 1), v(0, 1, 1)},
                   {v(1, 0, 0), v(0, 0, 0), v(1, 1, 0), v(1, 0, 1)},
                   {v(0, 1, 0), v(0, 0, 0), v(0, 1, 1), v(1, 1, 0)},
                   {v(0, 0, 1), v(0, 0, 0), v(1, 0, 1), v(0, 1, 1)},
                   {v(1, 1, 1), v(1, 1, 0), v(0, 1, 1), v(1, 0, 1)}};
    for (auto& [a, b, c, d] : cells) {
      const auto& p = distinct.points;
      if (orient3d(p[a], p[b], p[c], p[d]) == Sign::negative) std::swap(c, d);
    }
    return ref::triangulation_of_cells(distinct, cells);
  };
  const auto right_cells = ref::cell_set(ref::brute_force_delaunay(points));
  for (const int flip : {0, 1}) {
    const Triangulation triangulation = five_cells(flip);
    const DelaunayReport report = check_delaunay(triangulation);
    EXPECT_EQ(report.misoriented_cells, 0U);
    EXPECT_EQ(report.broken_neighbors, 0U);
    EXPECT_EQ(report.reflex_hull_edges, 0U);
    EXPECT_EQ(report.ok(), ref::cell_set(triangulation) == right_cells);
    EXPECT_EQ(report.occupied_spheres == 0, ref::occupied_pairs(triangulation) == 0);
  }
}

// Around the edge ab cells wind twice, as the sides of a pentagram do. Whatever is next to each
// other fits together, and is Delaunay: only a look at the whole tells.
TEST(CheckDelaunay, FindsCellsThatCoverSpaceTwice) {
  std::vector<Point> points{{0, 0, -1}, {0, 0, 1}};
  for (int i = 0; i < 5; ++i) {
    const double angle = 0.4 * std::numbers::pi * i;
    points.push_back({2 * std::cos(angle), 2 * std::sin(angle), 0});
  }
  const ref::DistinctPoints distinct = ref::distinct_points(points);
  const auto v = [&](int i) { return distinct.vertex_of_point[PointId(i)]; };
  for (const int step : {1, 2}) {
    CellList cells;
    for (int i = 0; i < 5; ++i) cells.push_back({v(0), v(1), v(2 + i), v(2 + (i + step) % 5)});
    const Triangulation triangulation = ref::triangulation_of_cells(distinct, cells);
    const DelaunayReport report = check_delaunay(triangulation);
    EXPECT_EQ(report.broken_neighbors, 0U);
    EXPECT_EQ(report.misoriented_cells, 0U);
    EXPECT_EQ(report.reflex_hull_edges, 0U);
    EXPECT_EQ(report.bad_links, 0U);
    EXPECT_EQ(report.occupied_spheres, 0U);
    EXPECT_EQ(ref::occupied_pairs(triangulation) == 0, step == 1);
    EXPECT_EQ(check_delaunay(triangulation).ok(), step == 1);
  }
}

// A facet in the middle of a flat face, so that no angle with its neighbors shows it.
TEST(CheckDelaunay, FindsAHullFacetTurnedOver) {
  const Triangulation good = ref::cgal_delaunay(gallery::integer_grid(5));
  const auto is_turned = [&](CellId hull) {
    IdVector<CellId, Cell> cells = good.cell_records();
    Cell& cell = cells[hull];
    std::swap(cell.vertices[0], cell.vertices[1]);
    std::swap(cell.neighbors[0], cell.neighbors[1]);
    for (const int i : {0, 1}) {
      const FacetId behind = cell.neighbors[static_cast<std::size_t>(i)];
      cells[cell_of(behind)].neighbors[static_cast<std::size_t>(index_of(behind))] =
          facet_id(hull, i);
    }
    return !check_delaunay(with_cells(good, cells)).ok();
  };
  for (const CellId hull : good.infinite_cells()) EXPECT_TRUE(is_turned(hull)) << hull.value;
}

TEST(CheckDelaunay, SameReportForEveryThreadCount) {
  Triangulation good = ref::cgal_delaunay(gallery::uniform_cube(5000));
  IdVector<VertexId, Point> points = good.points();
  Random random(3);
  for (Point& p : points) p = p + 0.01 * random.in_unit_cube();
  const Triangulation bad({points, good.cell_records(), good.vertex_of_point()},
                          good.num_finite_cells());
  const DelaunayReport one = check_delaunay(bad, {.threads = 1});
  const DelaunayReport three = check_delaunay(bad, {.threads = 3});
  EXPECT_FALSE(one.ok());
  EXPECT_EQ(one.first_violation, three.first_violation);
  EXPECT_EQ(one.misoriented_cells, three.misoriented_cells);
  EXPECT_EQ(one.reflex_hull_edges, three.reflex_hull_edges);
}

// Behind the third facet comes a cell at infinity, so that each of the four finds another one.
TEST(TriangulationOfCells, RefusesAFacetThatIsOfMoreThanTwoCells) {
  const ref::DistinctPoints distinct = ref::distinct_points(
      std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 2}, {0, 0, -1}});
  const auto v = [&](int i) { return distinct.vertex_of_point[PointId(i)]; };
  CellList cells{{v(0), v(1), v(2), v(3)}, {v(0), v(2), v(1), v(5)}};
  EXPECT_NO_THROW(ref::triangulation_of_cells(distinct, cells));
  cells.push_back({v(0), v(1), v(2), v(4)});
  EXPECT_THROW(ref::triangulation_of_cells(distinct, cells), InputError);
}

// The two oracles share no predicate: they must agree.
TEST(BruteForceDelaunay, SameCellsAsCgal) {
  using namespace gallery;
  for (const auto& points :
       {integer_grid(2), integer_grid(3), uniform_cube(28), integer_sphere(9), plane_and_apex(5),
        two_lines(8), repeated(uniform_cube(6), 3), ulp_pairs(12)}) {
    EXPECT_EQ(ref::cell_set(ref::brute_force_delaunay(points)),
              ref::cell_set(ref::cgal_delaunay(points)));
  }
}

TEST(CellSet, HashTellsSetsApart) {
  const std::vector<Point> points = gallery::uniform_cube(100);
  const Triangulation a = ref::cgal_delaunay(points);
  EXPECT_EQ(ref::cell_set(a).size(), a.num_finite_cells());
  EXPECT_EQ(ref::cell_set_hash(a), ref::cell_set_hash(ref::cgal_delaunay(points)));
  const Triangulation b = without_cell(points, CellId(7));
  EXPECT_NE(ref::cell_set_hash(a), ref::cell_set_hash(b));
  EXPECT_NE(ref::cell_set(a), ref::cell_set(b));
}

}  // namespace
}  // namespace cocoon
