#include "cocone/mark_cells.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <vector>

#include "ref/mark_in_rounds.h"
#include "tests/cocone/marked.h"
#include "tests/cocone/sample_shapes.h"

namespace cocoon {
namespace {

// The same marks by all rounds.
CellMarks marks_by_rounds(const Marked& m) {
  CellMarks rounds;
  rounds.good = m.marks.good;
  rounds.labels = IdVector<CellId, CellLabel>(m.s.triangulation.num_cells(), CellLabel::unmarked);
  rounds.visited = VertexSet(m.s.triangulation.num_vertices(), 0);
  std::vector<VertexId> seeds;
  for (const CellId c : m.s.triangulation.infinite_cells()) {
    for (int i = 0; i < 3; ++i) seeds.push_back(m.s.triangulation.vertex(c, i));
  }
  ref::mark_in_rounds(m.s.triangulation, m.surface, seeds, rounds);
  return rounds;
}

TEST(MarkCells, OnePassGivesWhatTheRoundsGive) {
  for (const auto& points : {shapes::random_torus(2500, 0.4, 1), shapes::cube_grid(9),
                             shapes::latitude_sphere(15, 24), shapes::cut_sphere(1500, 0.5, 2),
                             shapes::joined(shapes::sphere(1200, 3), shapes::sphere(500, 4, 0.4)),
                             shapes::plate(20, 3)}) {
    const Marked m(points);
    ASSERT_EQ(m.marks.rounds, 0U);
    const CellMarks rounds = marks_by_rounds(m);
    EXPECT_GT(rounds.rounds, 0U);
    EXPECT_EQ(rounds.conflicts, 0U);
    EXPECT_EQ(m.marks.labels, rounds.labels);
    EXPECT_EQ(m.marks.visited, rounds.visited);
    EXPECT_EQ(m.marks.visited_vertices, rounds.visited_vertices);
  }
}

// False if nobody disagreed.
bool is_settled_as_by_the_rounds(const Marked& m) {
  const CellMarks rounds = marks_by_rounds(m);
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

// What no mark reaches is in doubt where labels touch it, such as an inner wall.
TEST(MarkUndoubtedCells, WhatNoMarkReachesIsInDoubtIfLabelsTouchIt) {
  const Marked m(shapes::joined(shapes::sphere(1200, 3), shapes::sphere(500, 4, 0.4)));
  ASSERT_LT(m.marks.visited_vertices, m.marks.good_vertices);
  IdVector<CellId, CellLabel> doubts(m.s.triangulation.num_cells(), CellLabel::unmarked);
  const CellMarks none = m.undoubted(doubts);
  EXPECT_EQ(none.labels, m.marks.labels);
  EXPECT_EQ(none.good, m.marks.good);
  EXPECT_EQ(none.refuted_vertices, 0U);

  const auto is_inside = [&](CellId c) {
    const auto& corners = m.s.triangulation.cell(c).vertices;
    return std::all_of(corners.begin(), corners.end(),
                       [&](VertexId v) { return m.marks.good[v] != 0 && m.marks.visited[v] == 0; });
  };
  std::size_t touched = 0;
  for (const CellId c : m.s.triangulation.finite_cells()) {
    if (touched == 1 || !is_inside(c)) continue;
    doubts[c] = CellLabel::out;
    ++touched;
  }
  ASSERT_EQ(touched, 1U);
  const CellMarks marks = m.undoubted(doubts);
  EXPECT_EQ(marks.labels, m.marks.labels);
  EXPECT_TRUE(marks.known.empty());
  EXPECT_EQ(marks.refuted_vertices, m.marks.good_vertices - m.marks.visited_vertices);
  EXPECT_EQ(marks.good_vertices, m.marks.visited_vertices);
  EXPECT_EQ(marks.good, m.marks.visited);
}

// Air on both sides of a facet: the surface is none at its corners, and their cells are left to the
// clean-up, unless another vertex tells of them.
TEST(MarkUndoubtedCells, VerticesThatLabelsContradictAreInDoubt) {
  const Marked m(shapes::sphere(1200, 3));
  ASSERT_EQ(m.marks.visited_vertices, m.marks.good_vertices);
  FacetId f;
  m.surface.for_each(m.s.triangulation, [&](FacetId facet) { f = facet; });
  IdVector<CellId, CellLabel> doubts(m.s.triangulation.num_cells(), CellLabel::unmarked);
  for (const CellId c : {cell_of(f), cell_of(m.s.triangulation.mirror(f))}) {
    doubts[c] = CellLabel::out;
  }
  const CellMarks marks = m.undoubted(doubts);
  EXPECT_LE(marks.refuted_vertices, 4U);  // the fourth one of the cell inside, too
  EXPECT_EQ(marks.good_vertices + marks.refuted_vertices, m.marks.good_vertices);
  for (const VertexId v : m.s.triangulation.facet_vertices(f)) EXPECT_EQ(marks.good[v], 0);
  std::size_t left = 0;
  for (const CellId c : marks.labels.ids()) {
    if (marks.labels[c] == m.marks.labels[c]) continue;
    EXPECT_EQ(marks.labels[c], CellLabel::unmarked);
    ++left;
  }
  EXPECT_LE(left, 40U);
}

}  // namespace
}  // namespace cocoon
