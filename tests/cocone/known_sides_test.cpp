#include "cocone/known_sides.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <utility>
#include <vector>

#include "cocone/reconstruct.h"
#include "geom/mesh_check.h"
#include "geom/random.h"
#include "ref/mark_in_rounds.h"
#include "tests/cocone/sample_shapes.h"
#include "tests/cocone/stages.h"

namespace cocoon {
namespace {

std::vector<KnownTriangle> triangles_of(const ReconstructResult& result) {
  std::vector<KnownTriangle> known;
  for (const auto& [a, b, c] : result.mesh.triangles) {
    known.push_back(
        {result.point_of_vertex[a], result.point_of_vertex[b], result.point_of_vertex[c]});
  }
  return known;
}

// By hand: two cells, one above the other.
TEST(KnownSides, CellsBehindTheTrianglesAreInside) {
  const std::vector<Point> points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.2, 0.2, -1}};
  const Stages s(points);
  FacetSet all(s.triangulation.num_cells());
  for (const CellId c : s.triangulation.finite_cells()) {
    for (int i = 0; i < 4; ++i) all.insert(s.triangulation, facet_id(c, i));
  }
  const LinkedFacets linked = link_facets(s.triangulation, all);
  const auto known_by = [&](const std::vector<KnownTriangle>& triangles) {
    return known_sides(s.triangulation, linked, triangles);
  };
  const PointId a(0U);
  const PointId b(1U);
  const PointId c(2U);
  const PointId top(3U);
  const PointId low(4U);
  // The triangle between the two cells, counterclockwise seen from above: the lower one is inside.
  // The others, one of each cell, say the same.
  const KnownTriangle base = {a, b, c};
  const KnownTriangle of_upper = {b, a, top};
  const KnownTriangle of_lower = {a, low, b};
  const KnownSides sides = known_by({base, of_upper, of_lower});
  EXPECT_EQ(sides.cells, 2U);
  EXPECT_EQ(sides.contradictions, 0U);
  for (const CellId cell : s.triangulation.finite_cells()) {
    bool has_low = false;
    for (const VertexId v : s.triangulation.cell(cell).vertices) {
      has_low |= v == s.triangulation.vertex_of_point()[low];
    }
    EXPECT_EQ(sides.labels[cell], has_low ? CellLabel::in : CellLabel::out);
  }
  EXPECT_EQ(known_by({{b, c, a}, of_upper, of_lower}).labels, sides.labels);  // from any corner on
  // A cell told both, cells with a vertex that may be new, triangles that are no facets or not on
  // the surface: all say nothing.
  const KnownSides told_both = known_by({base, {a, b, top}, of_lower});
  EXPECT_EQ(told_both.contradictions, 1U);
  EXPECT_EQ(told_both.cells, 1U);
  EXPECT_EQ(known_by({base}).cells, 0U);
  EXPECT_EQ(known_by({{a, top, low}}).cells, 0U);
  const LinkedFacets nothing = link_facets(s.triangulation, FacetSet(s.triangulation.num_cells()));
  const std::vector<KnownTriangle> three = {base, of_upper, of_lower};
  EXPECT_EQ(known_sides(s.triangulation, nothing, three).cells, 0U);
  EXPECT_EQ(known_by({}).cells, 0U);
}

TEST(KnownSides, AgreeWithTheMarksOfTheSurface) {
  const std::vector<Point> points = shapes::random_torus(2500, 0.4, 1);
  const Stages s(points);
  const std::vector<KnownTriangle> triangles = triangles_of(reconstruct_tight(points));
  const BoundarySamples labels = s.labels();
  const LinkedFacets surface = s.surface(labels);
  const CellMarks marks = mark_cells(s.triangulation, surface, labels.boundary);
  const KnownSides known = known_sides(s.triangulation, surface, triangles);
  EXPECT_EQ(known.contradictions, 0U);
  EXPECT_GT(known.cells, points.size());
  for (const CellId c : s.triangulation.finite_cells()) {
    if (known.labels[c] != CellLabel::unmarked) {
      EXPECT_EQ(known.labels[c], marks.labels[c]);
    }
  }
}

// Where marks agree, they need no help: even nonsense changes nothing.
TEST(KnownSides, AreOnlyUsedWhereMarksContradictEachOther) {
  const std::vector<Point> points = shapes::sphere(1500, 3);
  const ReconstructResult plain = reconstruct_tight(points);
  std::vector<KnownTriangle> turned = triangles_of(plain);
  for (KnownTriangle& t : turned) std::swap(t[0], t[1]);
  const ReconstructResult again = reconstruct_tight_again(points, turned);
  EXPECT_EQ(again.mesh, plain.mesh);
  EXPECT_EQ(again.counters.known_cells, 0U);
}

// What all rounds give from the same known triangles.
CellMarks marks_by_rounds(const Stages& s, const LinkedFacets& surface,
                          const std::vector<KnownTriangle>& triangles, const CellMarks& marks) {
  CellMarks rounds;
  rounds.good = marks.good;
  rounds.visited = VertexSet(s.triangulation.num_vertices(), 0);
  rounds.labels = known_sides(s.triangulation, surface, triangles).labels;
  std::vector<VertexId> seeds;
  for (const CellId c : s.triangulation.cells()) {
    const bool is_known = rounds.labels[c] != CellLabel::unmarked;
    if (is_known && is_poor(s.triangulation, marks.good, c)) rounds.labels[c] = CellLabel::unmarked;
    if (!is_known && !s.triangulation.is_infinite(c)) continue;
    for (const VertexId v : s.triangulation.cell(c).vertices) {
      if (v != infinite_vertex) seeds.push_back(v);
    }
  }
  ref::mark_in_rounds(s.triangulation, surface.set, seeds, rounds);
  return rounds;
}

// Where vertices disagree, only they are asked: with the same result as all rounds, also if what is
// known is partly wrong. False if nobody disagreed.
bool is_settled_as_by_the_rounds(const Stages& s, std::vector<KnownTriangle> triangles,
                                 std::uint64_t seed, CellMarks& marks) {
  Random random(seed);
  for (KnownTriangle& t : triangles) {
    if (random.below(50) == 0) std::swap(t[0], t[1]);
  }
  std::erase_if(triangles, [&](const KnownTriangle&) { return random.below(4) == 0; });
  const BoundarySamples labels = s.labels();
  const LinkedFacets surface = s.surface(labels);
  marks = mark_cells(s.triangulation, surface, labels.boundary, triangles);
  if (marks.rounds == 0) return false;
  const CellMarks rounds = marks_by_rounds(s, surface, triangles, marks);
  EXPECT_EQ(marks.labels, rounds.labels);
  EXPECT_EQ(marks.visited, rounds.visited);
  EXPECT_EQ(marks.visited_vertices, rounds.visited_vertices);
  EXPECT_EQ(marks.rounds, rounds.rounds);
  EXPECT_EQ(marks.conflicts, rounds.conflicts);
  EXPECT_GT(marks.conflicts, 0U);
  return true;
}

TEST(KnownSides, DisputesAreSettledAsByTheRounds) {
  std::size_t disputed = 0;
  for (const std::uint64_t seed : {1U, 5U, 9U, 13U}) {
    const std::vector<Point> points = shapes::noisy_sphere(3000, 0.02, seed);
    CellMarks marks;
    if (is_settled_as_by_the_rounds(Stages(points), triangles_of(reconstruct_tight(points)), seed,
                                    marks)) {
      ++disputed;
    }
  }
  EXPECT_GT(disputed, 2U);
}

// A surface inside the body, which the hull does not see: known cells tell where it is.
TEST(KnownSides, DisputesAroundCavitiesAreSettledAsByTheRounds) {
  std::size_t disputed = 0;
  for (const std::uint64_t seed : {1U, 5U, 9U, 13U}) {
    const std::vector<Point> points =
        shapes::joined(shapes::noisy_sphere(3000, 0.02, seed), shapes::sphere(600, seed, 0.5));
    const Stages s(points);
    const CellMarks alone = mark_cells(s.triangulation, s.surface(s.labels()), s.labels().boundary);
    CellMarks marks;
    const ReconstructResult before = reconstruct_tight(points, {.keep_cavities = true});
    if (!is_settled_as_by_the_rounds(s, triangles_of(before), seed, marks)) continue;
    ++disputed;
    EXPECT_GT(marks.visited_vertices, alone.visited_vertices + 500);
  }
  EXPECT_GT(disputed, 2U);
}

// Noise makes marks contradict each other. With the triangles of the result so far their number
// falls, and the sides stay; in paper mode there is no such help.
TEST(KnownSides, SettleContradictions) {
  const std::vector<Point> points = shapes::noisy_sphere(3000, 0.03, 5);
  const ReconstructResult plain = reconstruct_tight(points);
  ASSERT_GT(plain.counters.marking_conflicts, 0U);
  const std::vector<KnownTriangle> known = triangles_of(plain);
  const ReconstructResult again = reconstruct_tight_again(points, known);
  EXPECT_GT(again.counters.known_cells, 1000U);
  EXPECT_EQ(again.status, SurfaceStatus::ok);
  const MeshReport before = mesh_check(plain.mesh);
  const MeshReport after = mesh_check(again.mesh);
  EXPECT_EQ(after.components, before.components);
  EXPECT_LE(after.pinched_vertices, before.pinched_vertices + 5);
  EXPECT_NEAR(static_cast<double>(again.mesh.triangles.size()),
              static_cast<double>(plain.mesh.triangles.size()), 60);
  const ReconstructOptions paper = {.mode = Mode::paper};
  EXPECT_EQ(reconstruct_tight_again(points, known, paper).mesh,
            reconstruct_tight(points, paper).mesh);
}

}  // namespace
}  // namespace cocoon
