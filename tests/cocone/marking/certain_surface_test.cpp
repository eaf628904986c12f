#include "cocone/marking/certain_surface.h"

#include <algorithm>
#include <cstdint>
#include <gtest/gtest.h>
#include <utility>
#include <vector>

#include "cocone/clean_up_cells.h"
#include "cocone/facets/facet_removal.h"
#include "cocone/mark_cells.h"
#include "cocone/peel_cells.h"
#include "cocone/prune_sharp_edges.h"
#include "cocone/surface_mesh.h"
#include "tests/cocone/sample_shapes.h"
#include "tests/cocone/stages.h"

namespace cocoon {
namespace {

struct Extracted {
  explicit Extracted(const std::vector<Point>& points) : s(points), boundary(s.labels().boundary) {
    PrunedCandidates pruned = prune_sharp_edges(
        s.triangulation, candidate_triangles(s.triangulation, s.cocones, boundary));
    surface = extract_manifold(s.triangulation, std::move(pruned.left), pruned.umbrella);
    good = good_vertices(surface.triangles, boundary);
  }
  bool is_certain() const { return cocoon::is_certain(s.triangulation, surface, good); }

  Stages s;
  VertexSet boundary;
  ManifoldSurface surface;
  GoodVertices good;
};

// Without one of its triangles.
void open(Extracted& e, std::size_t triangle) {
  std::vector<std::uint8_t> removed(e.surface.triangles.size(), 0);
  removed[triangle] = 1;
  for (const auto& [from, to] : moves_into_places(removed)) {
    e.surface.halves[to] = e.surface.halves[from];
  }
  e.surface.halves.pop_back();
  e.surface.triangles = without(e.s.triangulation, std::move(e.surface.triangles), removed);
  e.good = good_vertices(e.surface.triangles, e.boundary);
}

// What the later stages make of it is the surface itself, and nothing but that.
void expect_nothing_to_decide(const Extracted& e) {
  CellMarks marks = mark_cells(e.s.triangulation, e.surface.triangles, e.good, {});
  EXPECT_EQ(marks.visited_vertices, marks.good_vertices);
  EXPECT_EQ(marks.rounds, 0U);
  EXPECT_EQ(marks.conflicts, 0U);
  EXPECT_EQ(marks.known_cells, 0U);
  marks = peel_cells(e.s.triangulation, e.surface.triangles.set, std::move(marks));
  EXPECT_EQ(marks.poor_cells, 0U);
  EXPECT_EQ(marks.deferred_seeds, 0U);
  const CellMarks peeled = marks;
  const CleanUpCounters counters = clean_up_cells(e.s.triangulation, e.s.poles, marks);
  EXPECT_EQ(counters.undecided_cells, 0U);
  EXPECT_EQ(counters.changed_cells, 0U);
  EXPECT_EQ(counters.defects_before, 0U);
  EXPECT_EQ(counters.unused_after, counters.unused_before);
  EXPECT_EQ(marks.reached, peeled.reached);
  const SurfaceMesh body = surface_between(e.s.triangulation, marks);
  const SurfaceMesh shown = surface_of(e.s.triangulation, e.surface.halves);
  EXPECT_TRUE(body.mesh == shown.mesh);
  EXPECT_TRUE(body.point_of_vertex == shown.point_of_vertex);
  const SurfaceMesh same =
      surface_of(e.s.triangulation, e.surface.triangles, e.surface.halves, {.threads = 2});
  EXPECT_TRUE(same.mesh == shown.mesh);
  EXPECT_TRUE(same.triangulation_vertex == shown.triangulation_vertex);
  EXPECT_EQ(counters.unused_before, e.s.triangulation.num_vertices() - body.mesh.points.size());
}

TEST(CertainSurface, LeavesNothingToDecide) {
  std::size_t certain = 0;
  std::size_t folded = 0;    // of them: with a vertex that is not good, on it
  std::size_t left_out = 0;  // or off it
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const double size = 1 + 0.1 * static_cast<double>(seed % 5);
    for (const auto& points :
         {shapes::random_torus(4000, 0.3 * size, seed), shapes::sphere(600, seed),
          shapes::ellipsoid(1500, seed), shapes::joined(shapes::sphere(600, seed), {{0, 0, 0}}),
          shapes::noisy_sphere(700, 0.001 * static_cast<double>(seed), seed)}) {
      const Extracted e(points);
      if (!e.is_certain()) continue;
      expect_nothing_to_decide(e);
      ++certain;
      folded += e.good.folded.empty() ? 0U : 1U;
      const std::size_t on_surface = e.good.count + e.good.folded.size();
      left_out += on_surface < e.s.triangulation.num_vertices() ? 1U : 0U;
    }
  }
  EXPECT_GE(certain, 150U);
  EXPECT_GE(folded, 5U);
  EXPECT_GE(left_out, 50U);
}

TEST(CertainSurface, IsOneClosedPieceThatTheHullSees) {
  EXPECT_TRUE(Extracted(shapes::sphere(1200, 3)).is_certain());
  EXPECT_FALSE(Extracted(shapes::cut_sphere(1500, 0.5, 2)).is_certain());
  const auto far = shapes::moved(shapes::sphere(1200, 4), {10, 0, 0});
  EXPECT_FALSE(Extracted(shapes::joined(shapes::sphere(1200, 3), far)).is_certain());
  const auto inner = shapes::sphere(500, 4, 0.4);
  EXPECT_FALSE(Extracted(shapes::joined(shapes::sphere(1200, 3), inner)).is_certain());
  // Four samples far outside: the hull sees none of the others.
  const std::vector<Point> far_out = {{0, 0, 30}, {-30, -30, -30}, {30, -30, -30}, {0, 40, -30}};
  EXPECT_FALSE(Extracted(shapes::joined(shapes::sphere(1200, 3), far_out)).is_certain());
}

TEST(CertainSurface, HasNoHole) {
  Extracted e(shapes::sphere(1200, 3));
  open(e, 700);
  EXPECT_EQ(e.good.count, e.s.triangulation.num_vertices() - 3);
  EXPECT_FALSE(e.is_certain());
}

void fold(Extracted& e, VertexId v) {
  e.good.good[v] = 0;
  --e.good.count;
  e.good.folded.push_back(v);
  std::sort(e.good.folded.begin(), e.good.folded.end());
}

// The neighbors of v in the order of memory.
std::vector<VertexId> neighbors(const Extracted& e, VertexId v) {
  std::vector<VertexId> found;
  for (const Triangle& triangle : e.surface.triangles.corners) {
    if (std::count(triangle.begin(), triangle.end(), v) == 0) continue;
    for (const VertexId w : triangle) {
      if (w != v && std::count(found.begin(), found.end(), w) == 0) found.push_back(w);
    }
  }
  return found;
}

bool are_neighbors(const Extracted& e, VertexId v, VertexId w) {
  const std::vector<VertexId> around = neighbors(e, v);
  return std::count(around.begin(), around.end(), w) != 0;
}

// Marks pass around two or three folded vertices in a row, but not over a triangle of them.
TEST(CertainSurface, HasFoldsApart) {
  const VertexId v(300);
  Extracted e(shapes::sphere(1200, 3));
  fold(e, v);
  EXPECT_TRUE(e.is_certain());
  const std::vector<VertexId> around = neighbors(e, v);
  const VertexId w = around[0];
  fold(e, w);
  EXPECT_TRUE(e.is_certain());
  expect_nothing_to_decide(e);
  std::size_t in_row = 0;
  std::size_t in_triangle = 0;
  for (std::size_t k = 1; k < around.size(); ++k) {
    Extracted three = e;
    fold(three, around[k]);
    if (are_neighbors(e, w, around[k])) {
      EXPECT_FALSE(three.is_certain());
      ++in_triangle;
    } else {
      EXPECT_TRUE(three.is_certain());
      expect_nothing_to_decide(three);
      ++in_row;
    }
  }
  EXPECT_EQ(in_triangle, 2U);
  EXPECT_GE(in_row, 1U);
}

// Four samples inside make a cell that none of the good vertices has.
TEST(CertainSurface, TellsEveryCell) {
  const std::vector<Point> inside = {{0, 0, 0}, {0.1, 0, 0}, {0, 0.1, 0}, {0, 0, 0.1}};
  const std::vector<Point> one(inside.begin(), inside.begin() + 1);
  EXPECT_FALSE(Extracted(shapes::joined(shapes::sphere(1200, 3), inside)).is_certain());
  EXPECT_TRUE(Extracted(shapes::joined(shapes::sphere(1200, 3), one)).is_certain());
}

}  // namespace
}  // namespace cocoon
