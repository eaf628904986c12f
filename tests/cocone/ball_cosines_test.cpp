#include "cocone/ball_cosines.h"

#include <gtest/gtest.h>
#include <vector>

#include "delaunay/delaunay.h"
#include "delaunay/voronoi_dual.h"
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

template <class Visit>
void for_each_finite_facet(const Triangulation& t, Visit visit) {
  for (const CellId c : t.finite_cells()) {
    for (int i = 0; i < 4; ++i) visit(facet_id(c, i));
  }
}

TEST(BallCosines, AreTheHeightsOfTheCentersOverTheRadii) {
  const Triangulation t = delaunay(gallery::uniform_cube(500)).triangulation;
  BallCosines cosines(t);
  for_each_finite_facet(
      t, [&](FacetId f) { EXPECT_NEAR(cosines.of(f), cosine_by_definition(t, f), 1e-7); });
  for (const CellId c : t.infinite_cells()) EXPECT_EQ(cosines.of(facet_id(c, 3)), 1);
}

// The angle at which two balls meet is that between their radii to a common sample.
TEST(BallCosines, ContactIsTheAngleBetweenRadii) {
  const Triangulation t = delaunay(gallery::uniform_cube(500)).triangulation;
  BallCosines cosines(t);
  for_each_finite_facet(t, [&](FacetId f) {
    const FacetId mirror = t.mirror(f);
    EXPECT_EQ(cosines.contact(f), cosines.contact(mirror));
    if (t.is_infinite(cell_of(mirror))) return;
    const Point& sample = t.point(t.facet_vertices(f)[0]);
    const Vec3 here = unit(voronoi_vertex(t, cell_of(f)) - sample);
    const Vec3 there = unit(voronoi_vertex(t, cell_of(mirror)) - sample);
    EXPECT_NEAR(cosines.contact(f), dot(here, there), 1e-6);
  });
}

// Cells of one cube of a grid have one ball.
TEST(BallCosines, EqualBallsMeetAtACosineOfOne) {
  const Triangulation t = delaunay(gallery::integer_grid(2)).triangulation;
  BallCosines cosines(t);
  for_each_finite_facet(t, [&](FacetId f) {
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
  BallCosines ahead(t);
  ahead.prepare(cells, {.threads = 4});
  BallCosines asked(t);
  for_each_finite_facet(t, [&](FacetId f) { EXPECT_EQ(ahead.of(f), asked.of(f)); });
}

}  // namespace
}  // namespace cocoon
