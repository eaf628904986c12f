#include "cocone/known_labels.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <gtest/gtest.h>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "cocone/facets/half_star.h"
#include "cocone/mark_cells.h"
#include "cocone/marking/half_labels.h"
#include "cocone/reconstruct.h"
#include "delaunay/circulate.h"
#include "delaunay/delaunay.h"
#include "delaunay/vertex_stars.h"
#include "geom/mesh_check.h"
#include "geom/random/random.h"
#include "ref/mark_in_rounds.h"
#include "tests/cocone/known_triangles.h"
#include "tests/cocone/plain_labels.h"
#include "tests/cocone/sample_shapes.h"
#include "tests/cocone/stages.h"

namespace cocoon {
namespace {

FacetSet no_facets(const Triangulation& triangulation) {
  return FacetSet(triangulation.num_cells());
}

KnownLabelsSource told_by(std::vector<KnownTriangle> triangles) {
  return [triangles = std::move(triangles)](const Triangulation& triangulation,
                                            const FacetSet& surface, const Execution& execution) {
    return known_labels(triangulation, triangles, surface, execution);
  };
}

// By hand: two cells, one above the other.
TEST(KnownLabels, CellsBehindTheTrianglesAreInside) {
  const std::vector<Point> points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.2, 0.2, -1}};
  const Triangulation triangulation = delaunay(points).triangulation;
  ASSERT_EQ(triangulation.num_finite_cells(), 2U);
  const PointId a(0U);
  const PointId b(1U);
  const PointId c(2U);
  const PointId top(3U);
  const PointId low(4U);
  const VertexId low_vertex = triangulation.vertex_of_point()[low];
  // The labels of the upper cell and the lower one.
  const auto known_by = [&](const std::vector<KnownTriangle>& triangles) {
    const KnownLabels known = known_labels(triangulation, triangles, no_facets(triangulation));
    EXPECT_EQ(known.contradictions, 0U);
    std::pair<CellLabel, CellLabel> labels;
    for (const CellId cell : triangulation.finite_cells()) {
      (has_vertex(triangulation.cell(cell), low_vertex) ? labels.second : labels.first) =
          known.labels[cell];
    }
    const std::size_t unmarked = (labels.first == CellLabel::unmarked ? 1U : 0U) +
                                 (labels.second == CellLabel::unmarked ? 1U : 0U);
    EXPECT_EQ(known.cells, 2 - unmarked);
    return labels;
  };
  using enum CellLabel;
  const std::vector<KnownTriangle> lower = {{a, b, c}, {a, low, b}, {b, low, c}, {c, low, a}};
  std::vector<KnownTriangle> both = {{a, b, top}, {b, c, top}, {c, a, top},
                                     {a, low, b}, {b, low, c}, {c, low, a}};
  EXPECT_EQ(known_by(both), std::pair(in, in));
  // Also with a vertex that is no corner: it is new.
  EXPECT_EQ(known_by(lower), std::pair(out, in));
  std::vector<KnownTriangle> turned = both;
  for (KnownTriangle& t : turned) std::swap(t[0], t[1]);
  EXPECT_EQ(known_by(turned), std::pair(unmarked, unmarked));
  // The corners of a triangle that is not there are not intact. Then the two others tell both
  // cells, and one of them a cell.
  std::vector<KnownTriangle> torn = both;
  torn.erase(torn.begin());
  EXPECT_EQ(known_by(torn), std::pair(in, in));
  torn.erase(torn.begin());
  EXPECT_EQ(known_by(torn), std::pair(unmarked, in));
  // Not all triangles are facets.
  EXPECT_EQ(known_by({{a, b, top}, {a, low, b}, {b, low, top}, {top, low, a}}),
            std::pair(unmarked, unmarked));
  // Some are there twice.
  both.insert(both.end(), lower.begin(), lower.end());
  EXPECT_EQ(known_by(both), std::pair(in, unmarked));
  EXPECT_TRUE(known_labels(triangulation, {}, no_facets(triangulation)).labels.empty());
}

// Of two bodies one is turned inside out: what lies between them is told both.
TEST(KnownLabels, WhatIsToldBothIsNotKnown) {
  std::vector<Point> points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1},
                               {3, 0, 0}, {4, 0, 0}, {3, 1, 0}, {3, 0, 1}};
  for (const double x : {-20.0, 20.0}) {
    for (const double y : {-20.0, 20.0}) points.insert(points.end(), {{x, y, -20}, {x, y, 20}});
  }
  const Triangulation triangulation = delaunay(points).triangulation;
  const auto add_body = [](std::size_t first, std::vector<KnownTriangle>& triangles) {
    const std::array<PointId, 4> p{PointId(first), PointId(first + 1), PointId(first + 2),
                                   PointId(first + 3)};
    triangles.insert(
        triangles.end(),
        {{p[0], p[2], p[1]}, {p[0], p[1], p[3]}, {p[1], p[2], p[3]}, {p[2], p[0], p[3]}});
  };
  std::vector<KnownTriangle> triangles;
  add_body(0, triangles);
  add_body(4, triangles);
  const auto body_of = [](PointId p) { return p < PointId(8U) ? p.value / 4 : 2; };
  // Calls visit(cell, whether it has vertices of the first body, of the second one).
  const auto visit_cells = [&](const auto& visit) {
    for (const CellId c : triangulation.finite_cells()) {
      std::array<bool, 3> meets{};
      for (const VertexId v : triangulation.cell(c).vertices) {
        meets[body_of(triangulation.point_of_vertex(v))] = true;
      }
      visit(c, meets[0], meets[1]);
    }
  };
  const KnownLabels known = known_labels(triangulation, triangles, no_facets(triangulation));
  EXPECT_EQ(known.contradictions, 0U);
  EXPECT_EQ(std::count(known.labels.begin(), known.labels.end(), CellLabel::in), 2);
  for (std::size_t t = 4; t < 8; ++t) std::swap(triangles[t][0], triangles[t][1]);
  const KnownLabels turned = known_labels(triangulation, triangles, no_facets(triangulation));
  EXPECT_GT(turned.contradictions, 0U);
  using enum CellLabel;
  visit_cells([&](CellId c, bool meets_first, bool meets_second) {
    if (!meets_first && !meets_second) {
      EXPECT_EQ(known.labels[c], unmarked);
      EXPECT_EQ(turned.labels[c], unmarked);
    } else if (meets_first && meets_second) {
      EXPECT_EQ(known.labels[c], out);
      EXPECT_EQ(turned.labels[c], unmarked);
    } else {
      EXPECT_NE(known.labels[c], unmarked);
      const CellLabel opposite = known.labels[c] == in ? out : in;
      EXPECT_EQ(turned.labels[c], meets_first ? known.labels[c] : opposite);
    }
  });
}

// Compares what is told with its definition, from likely facets or none. Returns contradictions.
std::size_t expect_plain_sides(const std::vector<Point>& points,
                               const std::vector<KnownTriangle>& triangles, Random& random) {
  const Triangulation triangulation = delaunay(points).triangulation;
  const KnownLabels plain = PlainLabels(triangulation, triangles).labels();
  EXPECT_GT(plain.cells, 100U);
  FacetSet some = no_facets(triangulation);
  for (const CellId c : triangulation.finite_cells()) {
    for (int i = 0; i < 4; ++i) {
      if (random.below(3) == 0) some.insert(triangulation, facet_id(c, i));
    }
  }
  for (const int threads : {1, 3}) {
    const FacetSet likely = threads == 1 ? no_facets(triangulation) : some;
    const KnownLabels known = known_labels(triangulation, triangles, likely, {.threads = threads});
    EXPECT_EQ(known.labels, plain.labels);
    EXPECT_EQ(known.cells, plain.cells);
    EXPECT_EQ(known.contradictions, plain.contradictions);
  }
  return plain.contradictions;
}

// Also where some triangles are missing, turned, twice there or no facets any more. Where none is
// turned no cell is told both: then what is told goes from cell to cell.
TEST(KnownLabels, AreWhatEachVertexTellsByItself) {
  std::size_t contradictions = 0;
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U, 5U, 6U}) {
    Random random(seed);
    std::vector<Point> points =
        shapes::joined(shapes::sphere(60, seed, 0.3), shapes::random_torus(250, 0.4, seed));
    std::vector<KnownTriangle> triangles = triangles_of(reconstruct_tight(points));
    const std::uint64_t one_of = seed % 2 == 0 ? 20 : 200;
    std::erase_if(triangles, [&](const KnownTriangle&) { return random.below(one_of) == 0; });
    EXPECT_EQ(expect_plain_sides(points, triangles, random), 0U);
    for (KnownTriangle& t : triangles) {  // of the sphere all
      if (t[0] < PointId(60U) || random.below(one_of) == 0) std::swap(t[0], t[1]);
    }
    triangles.push_back(triangles.front());
    if (seed > 2) {
      for (Point& p : points) p = distance(p, {1, 0, 0}) < 0.5 ? p + Vec3{0, 0, 0.1} : p;
    }
    contradictions += expect_plain_sides(points, triangles, random);
  }
  EXPECT_GT(contradictions, 0U);
}

TEST(KnownLabels, AgreeWithTheMarksOfTheSurface) {
  const std::vector<Point> points = shapes::random_torus(2500, 0.4, 1);
  const Stages s(points);
  const std::vector<KnownTriangle> triangles = triangles_of(reconstruct_tight(points));
  const BoundarySamples labels = s.labels();
  const LinkedFacets surface = s.surface(labels);
  const CellMarks marks = mark_cells(s.triangulation, surface, labels.boundary);
  const KnownLabels known = known_labels(s.triangulation, triangles, no_facets(s.triangulation));
  EXPECT_EQ(known.contradictions, 0U);
  EXPECT_GT(known.cells, points.size());
  for (const CellId c : s.triangulation.finite_cells()) {
    if (known.labels[c] != CellLabel::unmarked) {
      EXPECT_EQ(known.labels[c], marks.labels[c]);
    }
  }
}

// Where marks agree, they need no help: even nonsense changes nothing.
TEST(KnownLabels, AreOnlyUsedWhereMarksContradictEachOther) {
  const std::vector<Point> points = shapes::sphere(1500, 3);
  const ReconstructResult plain = reconstruct_tight(points);
  std::vector<KnownTriangle> turned = triangles_of(plain);
  for (KnownTriangle& t : turned) std::swap(t[0], t[1]);
  const ReconstructResult again = reconstruct_tight_with_labels(points, told_by(turned));
  EXPECT_EQ(again.mesh, plain.mesh);
  EXPECT_EQ(again.counters.known_cells, 0U);
}

// What all rounds give from the same known triangles.
CellMarks marks_by_rounds(const Stages& s, const LinkedFacets& surface,
                          const std::vector<KnownTriangle>& triangles, const CellMarks& marks) {
  CellMarks rounds;
  rounds.good = marks.good;
  rounds.visited = VertexSet(s.triangulation.num_vertices(), 0);
  rounds.labels = known_labels(s.triangulation, triangles, no_facets(s.triangulation)).labels;
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

// How many good vertices have closed umbrellas that known cells contradict.
std::size_t count_refuted(const Triangulation& triangulation, const FacetSet& surface,
                          const CellMarks& marks) {
  const VertexStars stars = vertex_stars(triangulation);
  HalfStar half(triangulation, surface);
  std::size_t count = 0;
  for (const VertexId v : triangulation.vertices()) {
    if (marks.good[v] == 0) continue;
    half.flood(v, stars.star(v).front());
    LabelCount flooded;
    LabelCount rest;
    for (const CellId c : stars.star(v)) {
      const CellLabel side = triangulation.is_infinite(c) ? CellLabel::out : marks.known[c];
      (half.contains(c) ? flooded : rest).add(side);
    }
    count += label_halves(flooded, rest).conflict ? 1U : 0U;
  }
  return count;
}

// Where vertices disagree, only they are asked: with the same result as all rounds, also if what is
// known is partly wrong. Of a quarter of the body nothing is known: there they go on to disagree,
// while elsewhere those that known cells refute are not good. False if nobody disagreed.
bool is_settled_as_by_the_rounds(const Stages& s, std::vector<KnownTriangle> triangles,
                                 std::uint64_t seed, CellMarks& marks) {
  Random random(seed);
  for (KnownTriangle& t : triangles) {
    if (random.below(50) == 0) std::swap(t[0], t[1]);
  }
  std::erase_if(triangles, [&](const KnownTriangle& t) {
    const Point& p = s.triangulation.point(s.triangulation.vertex_of_point()[t[0]]);
    return (p.x > 0 && p.y > 0) || random.below(4) == 0;
  });
  const BoundarySamples labels = s.labels();
  const LinkedFacets surface = s.surface(labels);
  marks = mark_cells(s.triangulation, surface, labels.boundary, told_by(triangles));
  if (marks.rounds == 0) return false;
  const CellMarks rounds = marks_by_rounds(s, surface, triangles, marks);
  EXPECT_EQ(marks.labels, rounds.labels);
  EXPECT_EQ(marks.visited, rounds.visited);
  EXPECT_EQ(marks.visited_vertices, rounds.visited_vertices);
  EXPECT_EQ(marks.rounds, rounds.rounds);
  EXPECT_EQ(marks.conflicts, rounds.conflicts);
  EXPECT_GT(marks.refuted_vertices, 0U);
  EXPECT_EQ(count_refuted(s.triangulation, surface.set, marks), 0U);
  EXPECT_EQ(marks.good_vertices, static_cast<std::size_t>(std::count(
                                     marks.good.begin(), marks.good.end(), std::uint8_t{1})));
  return true;
}

TEST(KnownLabels, DisputesAreSettledAsByTheRounds) {
  std::size_t disputed = 0;
  std::size_t conflicts = 0;
  for (const std::uint64_t seed : {1U, 5U, 9U, 13U}) {
    const std::vector<Point> points = shapes::noisy_sphere(3000, 0.02, seed);
    CellMarks marks;
    if (is_settled_as_by_the_rounds(Stages(points), triangles_of(reconstruct_tight(points)), seed,
                                    marks)) {
      ++disputed;
      conflicts += marks.conflicts;
    }
  }
  EXPECT_GT(disputed, 2U);
  EXPECT_GT(conflicts, 0U);
}

// Known cells may have just the labels that were carried to them from a surface the hull sees, and
// contradict each other at vertices of another one that it does not see.
TEST(KnownLabels, RefuteVerticesThatTheHullDoesNotSee) {
  for (const std::uint64_t seed : {50U, 468U, 494U}) {
    std::vector<Point> inner = shapes::noisy_sphere(270, 0.013, seed + 1);
    for (Point& p : inner) p = 0.7 * p + Vec3{0.08, 0, 0};
    const Stages s(shapes::joined(shapes::noisy_sphere(540, 0.013, seed), inner));
    const BoundarySamples labels = s.labels();
    const LinkedFacets surface = s.surface(labels);
    const CellMarks carried = mark_cells(s.triangulation, surface, labels.boundary);
    ASSERT_LT(carried.visited_vertices, carried.good_vertices);
    const auto told = [&](const Triangulation& t, const FacetSet&, const Execution&) {
      KnownLabels known;
      known.labels = carried.labels;
      for (const CellId c : t.infinite_cells()) known.labels[c] = CellLabel::unmarked;
      return known;
    };
    const CellMarks marks = mark_cells(s.triangulation, surface, labels.boundary, told);
    EXPECT_EQ(count_refuted(s.triangulation, surface.set, marks), 0U) << "seed " << seed;
  }
}

// A surface inside the body, which the hull does not see: known cells tell where it is.
TEST(KnownLabels, DisputesAroundCavitiesAreSettledAsByTheRounds) {
  std::size_t disputed = 0;
  for (const std::uint64_t seed : {1U, 5U, 9U, 13U}) {
    const std::vector<Point> points =
        shapes::joined(shapes::noisy_sphere(3000, 0.02, seed), shapes::sphere(600, seed, 0.5));
    const Stages s(points);
    CellMarks marks;
    const ReconstructResult before =
        reconstruct_tight(points, {.second_look = {.enabled = false}, .keep_cavities = true});
    if (!is_settled_as_by_the_rounds(s, triangles_of(before), seed, marks)) continue;
    ++disputed;
    std::size_t inside = 0;
    for (const VertexId v : s.triangulation.vertices()) {
      if (norm(s.triangulation.point(v)) < 0.6) inside += marks.visited[v];
    }
    EXPECT_GT(inside, 300U);  // of 600, some of them next to what is told wrongly
  }
  EXPECT_GT(disputed, 2U);
}

// Noise makes marks contradict each other. With the triangles of the result so far their number
// falls, and the sides stay; in paper mode there is no such help.
TEST(KnownLabels, SettleContradictions) {
  const std::vector<Point> points = shapes::noisy_sphere(3000, 0.03, 5);
  const ReconstructResult plain = reconstruct_tight(points);
  ASSERT_GT(plain.counters.marking_conflicts, 0U);
  const std::vector<KnownTriangle> known = triangles_of(plain);
  const ReconstructResult again = reconstruct_tight_with_labels(points, told_by(known));
  EXPECT_GT(again.counters.known_cells, 1000U);
  EXPECT_LT(again.counters.marking_conflicts, plain.counters.marking_conflicts);
  EXPECT_EQ(again.status, SurfaceStatus::ok);
  const MeshReport before = mesh_check(plain.mesh);
  const MeshReport after = mesh_check(again.mesh);
  EXPECT_EQ(after.components, before.components);
  EXPECT_LE(after.pinched_vertices, before.pinched_vertices + 5);
  EXPECT_NEAR(static_cast<double>(again.mesh.triangles.size()),
              static_cast<double>(plain.mesh.triangles.size()), 60);
  const ReconstructOptions paper = {.mode = Mode::paper};
  EXPECT_EQ(reconstruct_tight_with_labels(points, told_by(known), paper).mesh,
            reconstruct_tight(points, paper).mesh);
}

// A mesh, as the result of its own vertices.
ReconstructResult model_of(const std::vector<Point>& points, bool clean_up = true) {
  ReconstructOptions options;
  options.clean_up.enabled = clean_up;
  ReconstructResult model = reconstruct_tight(points, options);
  for (const VertexId v : model.point_of_vertex.ids()) model.point_of_vertex[v] = PointId(v.value);
  return model;
}

// Noise leaves cells without good vertices, too. Told a mesh, its vertices give just that mesh.
TEST(KnownLabels, AMeshIsGivenAgain) {
  std::size_t known_cells = 0;
  std::size_t stirred = 0;
  for (const std::uint64_t seed : {5U, 6U}) {
    for (const std::vector<Point>& samples :
         {shapes::noisy_sphere(3000, 0.01, seed), shapes::noisy_sphere(3000, 0.03, seed),
          shapes::random_torus(2500, 0.4, seed), shapes::random_torus(700, 0.4, seed)}) {
      for (const bool clean_up : {true, false}) {  // without it, another mesh than its points give
        const ReconstructResult model = model_of(samples, clean_up);
        const Points points = model.mesh.points.span();
        const std::vector<KnownTriangle> known = triangles_of(model);
        const ReconstructResult again = reconstruct_tight_with_labels(points, told_by(known));
        known_cells += again.counters.known_cells;
        EXPECT_TRUE(again.mesh == model.mesh) << seed << ' ' << samples.size() << ' ' << clean_up;
        stirred += reconstruct_tight(points).mesh == model.mesh ? 0U : 1U;
        const ReconstructOptions paper = {.mode = Mode::paper};
        EXPECT_TRUE(reconstruct_tight_with_labels(points, told_by(known), paper).mesh ==
                    reconstruct_tight(points, paper).mesh);
      }
    }
  }
  EXPECT_GT(known_cells, 9000U);
  EXPECT_GT(stirred, 4U);
}

// A spike that the stages would leave out, beside a body with cells that nothing decides.
TEST(KnownLabels, ASpikeStays) {
  std::vector<Point> samples = shapes::random_torus(300, 0.4, 5);
  for (Point& p : samples) p = p + Vec3{4, 0, 0};
  ReconstructResult model = model_of(shapes::joined(shapes::sphere(1500, 3), samples));
  TriangleMesh& mesh = model.mesh;
  const auto [a, b, c] = mesh.triangles[TriangleId(0U)];
  ASSERT_LT(mesh.points[a].x, 2);
  const VertexId top(mesh.points.size());
  mesh.points.push_back((1.1 / 3) * (mesh.points[a] + mesh.points[b] + mesh.points[c]));
  model.point_of_vertex.push_back(PointId(top.value));
  mesh.triangles[TriangleId(0U)] = {a, b, top};
  mesh.triangles.push_back({b, c, top});
  mesh.triangles.push_back({c, a, top});
  canonicalize_triangles(mesh);
  const Points points = mesh.points.span();
  EXPECT_TRUE(reconstruct_tight_with_labels(points, told_by(triangles_of(model))).mesh == mesh);
  EXPECT_EQ(reconstruct_tight(points).unused_points, 1U);
}

// The triangles with all corners farther from the north pole than this, from their smallest ones
// on, in order.
std::vector<KnownTriangle> far_triangles(const ReconstructResult& result, Points points,
                                         double reach) {
  std::vector<KnownTriangle> far = triangles_of(result);
  std::erase_if(far, [&](const KnownTriangle& t) {
    return std::any_of(t.begin(), t.end(), [&](PointId p) {
      return distance(points[p.index()], {0, 0, 1}) < reach;
    });
  });
  for (KnownTriangle& t : far) {
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  }
  std::sort(far.begin(), far.end());
  return far;
}

// Where vertices have moved the surface changes; far from there each triangle stays, whatever the
// marks say of it.
TEST(KnownLabels, WhatIsFarFromAChangeStays) {
  std::size_t stirred = 0;
  for (const std::uint64_t seed : {5U, 6U, 7U, 8U}) {
    const ReconstructResult model = model_of(shapes::noisy_sphere(3000, 0.03, seed));
    const Points points = model.mesh.points.span();
    std::vector<Point> moved(points.begin(), points.end());
    for (Point& p : moved) {
      if (distance(p, {0, 0, 1}) < 0.4) p = p + Vec3{0, 0, 0.05};
    }
    const std::vector<KnownTriangle> kept = far_triangles(model, points, 0.9);
    const auto lost_of = [&](const ReconstructResult& result) {
      const std::vector<KnownTriangle> now = far_triangles(result, points, 0.9);
      return std::count_if(kept.begin(), kept.end(), [&](const KnownTriangle& t) {
        return !std::binary_search(now.begin(), now.end(), t);
      });
    };
    const std::vector<KnownTriangle> known = far_triangles(model, points, 0.6);
    EXPECT_EQ(lost_of(reconstruct_tight_with_labels(moved, told_by(known))), 0) << seed;
    stirred += lost_of(reconstruct_tight(moved)) == 0 ? 0U : 1U;
  }
  EXPECT_GT(stirred, 0U);
}

}  // namespace
}  // namespace cocoon
