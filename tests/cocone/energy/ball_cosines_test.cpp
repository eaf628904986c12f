#include "cocone/energy/ball_cosines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <numbers>
#include <vector>

#include "cocone/facets/cell_order.h"
#include "delaunay/delaunay.h"
#include "delaunay/voronoi_dual.h"
#include "geom/random/random.h"
#include "tests/gallery.h"

namespace cocoon {
namespace {

// The height of the center above the facet, on the side of the cell, over the radius.
double cosine_by_definition(const Triangulation& t, FacetId f) {
  const CellId c = cell_of(f);
  const Point center = voronoi_vertex(t, c);
  const auto [a, b, d] = t.facet_vertices(f);  // normal out of the cell
  const Vec3 inward = -unit(cross(t.point(b) - t.point(a), t.point(d) - t.point(a)));
  return dot(inward, center - t.point(a)) / norm(center - t.point(a));
}

// Each inner one from both sides: the two have balls of their own.
template <class Visit>
void for_each_side_of_finite_facets(const Triangulation& t, Visit visit) {
  for (const CellId c : t.finite_cells()) {
    for (int i = 0; i < 4; ++i) visit(facet_id(c, i));
  }
}

TEST(BallCosines, AreTheHeightsOfTheCentersOverTheRadii) {
  const Triangulation t = delaunay(gallery::uniform_cube(500)).triangulation;
  BallCosines cosines(t, 0);
  for_each_side_of_finite_facets(
      t, [&](FacetId f) { EXPECT_NEAR(cosines.of(f), cosine_by_definition(t, f), 1e-7); });
  for (const CellId c : t.infinite_cells()) EXPECT_EQ(cosines.of(facet_id(c, 3)), 1);
}

// The same expressions one by one, on corners in lexicographic order.
double plain_cosine(const Triangulation& t, FacetId f) {
  std::array<Point, 3> p = sorted_corners(t, f);
  const CellId c = cell_of(f);
  const Point center = voronoi_vertex(t, c);
  const double radius = norm(center - sorted_corners(t, c)[0]);
  const Vec3 normal = cross(p[1] - p[0], p[2] - p[0]);
  const double lengths = norm(normal) * radius;
  if (!(lengths > 0) || !std::isfinite(lengths)) return 0;
  const double cosine = dot(normal, center - p[0]) / lengths;
  const double height = dot(normal, t.point(t.vertex(c, index_of(f))) - p[0]);
  return std::clamp(height > 0 ? cosine : -cosine, -1.0, 1.0);
}

TEST(BallCosines, ManyAtOnceAreTheSameBitForBit) {
  for (const auto& points : {gallery::uniform_cube(700), gallery::integer_grid(5),
                             gallery::bumpy_sphere(700), gallery::even_sphere(300)}) {
    const Triangulation t = delaunay(points).triangulation;
    BallCosines cosines(t, 0);
    for_each_side_of_finite_facets(
        t, [&](FacetId f) { EXPECT_EQ(cosines.of(f), plain_cosine(t, f)); });
  }
}

// The angle at which two balls meet is that between their radii to a common sample.
TEST(BallCosines, ContactIsTheAngleBetweenRadii) {
  const Triangulation t = delaunay(gallery::uniform_cube(500)).triangulation;
  BallCosines cosines(t, 0);
  for_each_side_of_finite_facets(t, [&](FacetId f) {
    const FacetId mirror = t.mirror(f);
    EXPECT_EQ(cosines.contact(f), cosines.contact(mirror));
    if (t.is_infinite(cell_of(mirror))) return;
    const Point& sample = t.point(t.facet_vertices(f)[0]);
    const Vec3 here = unit(voronoi_vertex(t, cell_of(f)) - sample);
    const Vec3 there = unit(voronoi_vertex(t, cell_of(mirror)) - sample);
    EXPECT_NEAR(cosines.contact(f), dot(here, there), 1e-6);
  });
}

// A regular tetrahedron: the ball's tangent plane at a facet's circle leans by acos(1/3) inward.
TEST(BallCosines, OfARegularTetrahedron) {
  const std::vector<Point> corners{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
  const Triangulation t = delaunay(corners).triangulation;
  BallCosines cosines(t, 0);
  for (int i = 0; i < 4; ++i) {
    const FacetId f = facet_id(CellId(0), i);
    EXPECT_NEAR(cosines.of(f), 1.0 / 3, 1e-15);
    EXPECT_EQ(cosines.of(t.mirror(f)), 1);
    EXPECT_NEAR(cosines.contact(f), -1.0 / 3, 1e-15);
    EXPECT_EQ(cosines.contact(f), cosines.contact(t.mirror(f)));
  }
}

// Cells of one cube of a grid have one ball.
TEST(BallCosines, EqualBallsMeetAtACosineOfOne) {
  const Triangulation t = delaunay(gallery::integer_grid(2)).triangulation;
  BallCosines cosines(t, 0);
  for_each_side_of_finite_facets(t, [&](FacetId f) {
    if (t.is_infinite(cell_of(t.mirror(f)))) return;
    EXPECT_NEAR(cosines.contact(f), 1, 1e-12);
  });
}

TEST(BallCosines, PreparedOrNotTheyAreTheSame) {
  const Triangulation t = delaunay(gallery::uniform_cube(2000)).triangulation;
  std::vector<CellId> cells;
  for (const CellId c : t.cells()) {
    if (c.index() % 3 != 0) cells.push_back(c);
  }
  BallCosines ahead(t, 0);
  ahead.prepare(cells, {.threads = 4});
  BallCosines asked(t, 0);
  for_each_side_of_finite_facets(t, [&](FacetId f) { EXPECT_EQ(ahead.of(f), asked.of(f)); });
}

// Samples on a circle, in one plane but for rounding, and one apex on each side: balls of radius
// 1.25 with centers 0.75 above and below, and a pile of cells without height between.
struct Disk {
  explicit Disk(int count) {
    const Vec3 u = unit(Vec3{1, 2, 3});
    const Vec3 v = unit(cross(u, Vec3{0.3, -1, 0.2}));
    axis = cross(u, v);
    for (int k = 0; k < count; ++k) {
      const double angle = 2 * std::numbers::pi * k / count;
      points.push_back(std::cos(angle) * u + std::sin(angle) * v);
    }
    points.push_back(2 * axis);
    points.push_back(-2 * axis);
    t = delaunay(points).triangulation;
    for (const CellId c : t.finite_cells()) {
      ends[c] = 0;
      for (const VertexId w : t.cell(c).vertices) {
        const double height = dot(t.point(w), axis);
        if (std::abs(height) > 1) ends[c] = height > 0 ? 1 : -1;
      }
    }
  }
  Vec3 axis;
  std::vector<Point> points;
  Triangulation t;
  std::map<CellId, int> ends;  // 1, -1: has the apex above or below; 0: neither, so it is flat
};

TEST(BallCosines, FlatCellsAreThoseWithoutHeight) {
  const Disk disk(24);
  BallCosines cosines(disk.t, 1e-6);
  BallCosines without(disk.t, 0);
  std::size_t flat = 0;
  for (const auto& [c, end] : disk.ends) {
    EXPECT_EQ(cosines.is_flat(c), end == 0);
    EXPECT_FALSE(without.is_flat(c));
    flat += end == 0 ? 1U : 0U;
  }
  EXPECT_GT(flat, 5U);
  for (const CellId c : disk.t.infinite_cells()) EXPECT_FALSE(cosines.is_flat(c));
}

TEST(BallCosines, BallsMeetThroughFlatCells) {
  const Disk disk(24);
  const Triangulation& t = disk.t;
  BallCosines cosines(t, 1e-6);
  std::size_t met = 0;
  for_each_side_of_finite_facets(t, [&](FacetId f) {
    const int here = disk.ends.at(cell_of(f));
    if (here == 0) return;
    const CellId beyond = cosines.beyond(f);
    ASSERT_FALSE(beyond.is_none());
    const CellId behind = t.neighbor(cell_of(f), index_of(f));
    if (t.is_infinite(behind) || disk.ends.at(behind) != 0) {
      EXPECT_EQ(beyond, behind);
    }
    if (t.is_infinite(beyond) || disk.ends.at(beyond) == here) return;
    EXPECT_EQ(disk.ends.at(beyond), -here);
    EXPECT_NEAR(cosines.contact(f), (1 - 0.75 * 0.75) / (1.25 * 1.25), 1e-6);
    EXPECT_EQ(cosines.contact(f), cosines.contact(t.mirror(f)));
    ++met;
  });
  EXPECT_GE(met, 44U);  // 22 triangles on each side
  for (const auto& [c, end] : disk.ends) {
    if (end != 0) continue;
    const auto [one, other] = cosines.sides_of_flat(c);
    EXPECT_EQ(disk.ends.at(one) * disk.ends.at(other), -1);
  }
}

// Two triangles of a face that meet at less than a rounding error: between their samples and the
// convex hull, whose facets lead from one to the other, the cells are flat, and lie on each other.
TEST(BallCosines, PilesOfAnyHeightAreLookedThrough) {
  Random random(5);
  std::vector<Point> points = {{0.5, 0.5, 1}};
  for (int k = 0; k < 2000; ++k) {
    const double x = random.uniform();
    const double y = random.uniform();
    points.push_back({x, y, -1e-15 * std::abs(x - y)});
  }
  const Triangulation t = delaunay(points).triangulation;
  BallCosines cosines(t, 1e-6);
  std::size_t flat = 0;
  for (const CellId c : t.finite_cells()) {
    if (!cosines.is_flat(c)) continue;
    ++flat;
    const auto [one, other] = cosines.sides_of_flat(c);
    ASSERT_FALSE(one.is_none() || other.is_none());
    EXPECT_NE(t.is_infinite(one), t.is_infinite(other));  // the other one has the apex
  }
  EXPECT_GT(flat, 5000U);
}

}  // namespace
}  // namespace cocoon
