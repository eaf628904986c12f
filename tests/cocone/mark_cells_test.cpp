#include "cocone/mark_cells.h"

#include <gtest/gtest.h>

#include "cocone/peel_cells.h"
#include "cocone/surface_mesh.h"
#include "delaunay/circulate.h"
#include "ref/mark_in_rounds.h"
#include "tests/cocone/sample_shapes.h"
#include "tests/cocone/stages.h"

namespace cocoon {
namespace {

struct Marked {
  explicit Marked(const std::vector<Point>& points) : s(points), labels(s.labels()) {
    const LinkedFacets triangles = s.surface(labels);
    marks = mark_cells(s.triangulation, triangles, labels.boundary);
    surface = triangles.set;
  }

  CellMarks by_rounds() const {
    CellMarks rounds;
    rounds.good = marks.good;
    rounds.labels = IdVector<CellId, CellLabel>(s.triangulation.num_cells(), CellLabel::unmarked);
    rounds.visited = VertexSet(s.triangulation.num_vertices(), 0);
    std::vector<VertexId> seeds;
    for (const CellId c : s.triangulation.infinite_cells()) {
      for (int i = 0; i < 3; ++i) seeds.push_back(s.triangulation.vertex(c, i));
    }
    ref::mark_in_rounds(s.triangulation, surface, seeds, rounds);
    return rounds;
  }

  Stages s;
  BoundarySamples labels;
  FacetSet surface;
  CellMarks marks;
};

TEST(MarkCells, OnePassGivesWhatTheRoundsGive) {
  for (const auto& points : {shapes::random_torus(2500, 0.4, 1), shapes::cube_grid(9),
                             shapes::latitude_sphere(15, 24), shapes::cut_sphere(1500, 0.5, 2),
                             shapes::joined(shapes::sphere(1200, 3), shapes::sphere(500, 4, 0.4)),
                             shapes::plate(20, 3)}) {
    const Marked m(points);
    ASSERT_EQ(m.marks.rounds, 0U);
    const CellMarks rounds = m.by_rounds();
    EXPECT_GT(rounds.rounds, 0U);
    EXPECT_EQ(rounds.conflicts, 0U);
    EXPECT_EQ(m.marks.labels, rounds.labels);
    EXPECT_EQ(m.marks.visited, rounds.visited);
    EXPECT_EQ(m.marks.visited_vertices, rounds.visited_vertices);
  }
}

// False if nobody disagreed.
bool is_settled_as_by_the_rounds(const Marked& m) {
  const CellMarks rounds = m.by_rounds();
  EXPECT_EQ(m.marks.labels, rounds.labels);
  EXPECT_EQ(m.marks.visited, rounds.visited);
  EXPECT_EQ(m.marks.visited_vertices, rounds.visited_vertices);
  EXPECT_EQ(m.marks.conflicts, rounds.conflicts);
  if (m.marks.rounds == 0) return false;
  EXPECT_EQ(m.marks.rounds, rounds.rounds);
  return true;
}

// Where vertices disagree, only they are asked: with the same result as all rounds.
TEST(MarkCells, DisputesAreSettledAsByTheRounds) {
  std::size_t conflicts = 0;
  std::size_t disputed = 0;
  for (const double noise : {0.01, 0.015, 0.02, 0.03, 0.05}) {
    for (const std::uint64_t seed : {1U, 5U, 9U}) {
      const Marked m(shapes::noisy_sphere(3000, noise, seed));
      if (!is_settled_as_by_the_rounds(m)) continue;
      ++disputed;
      conflicts += m.marks.conflicts;
    }
  }
  EXPECT_GT(disputed, 5U);
  EXPECT_GT(conflicts, 20U);
}

// A surface without two sides: OUT comes to every place from both.
TEST(MarkCells, AOneSidedSurfaceIsMarkedAsByTheRounds) {
  for (const double jitter : {0.1, 0.3, 0.6}) {
    const Marked m(shapes::moebius_strip(150, 13, jitter, 4));
    EXPECT_GT(m.marks.good_vertices, 500U);
    EXPECT_TRUE(is_settled_as_by_the_rounds(m));
    EXPECT_GT(m.marks.conflicts, 0U);
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

TEST(MarkCells, SurfaceSeparatesInFromOut) {
  const Marked m(shapes::random_torus(2000, 0.4, 6));
  m.surface.for_each(m.s.triangulation, [&](FacetId f) {
    const CellLabel here = m.marks.labels[cell_of(f)];
    const CellLabel there = m.marks.labels[cell_of(m.s.triangulation.mirror(f))];
    EXPECT_NE(here, CellLabel::unmarked);
    EXPECT_NE(there, CellLabel::unmarked);
    EXPECT_NE(here, there);
  });
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

}  // namespace
}  // namespace cocoon
