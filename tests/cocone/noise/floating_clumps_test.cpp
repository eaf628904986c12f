#include "cocone/noise/floating_clumps.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <gtest/gtest.h>
#include <vector>

#include "cocone/noise/rough_surface.h"
#include "cocone/noise/sample_parts.h"
#include "cocone/robust_cocone.h"
#include "cocone/samples/sample_spacing.h"
#include "delaunay/delaunay.h"
#include "delaunay/voronoi_dual.h"
#include "geom/mesh_check.h"
#include "geom/random/random.h"
#include "tests/cocone/sample_shapes.h"
#include "tests/gallery.h"

namespace cocoon {
namespace {

// So many around a point, normally distributed.
std::vector<Point> clump(std::size_t count, const Point& center, double deviation,
                         std::uint64_t seed) {
  Random random(seed);
  std::vector<Point> points;
  for (std::size_t i = 0; i < count; ++i) {
    points.push_back(center +
                     deviation * Vec3{random.gaussian(), random.gaussian(), random.gaussian()});
  }
  return points;
}

std::vector<Point> even_ball(std::size_t count, double radius, const Point& center) {
  std::vector<Point> points = gallery::even_sphere(count);
  for (Point& p : points) p = center + radius * (p - Point{0, 0, 0});
  return points;
}

// A sphere of 3000 samples, 0.065 apart.
std::vector<Point> body() { return even_ball(3000, 1, {0, 0, 0}); }

// The body, and clumps beside it.
std::vector<Point> body_with_clumps() {
  std::vector<Point> points = shapes::joined(body(), clump(30, {0, 0, 2}, 0.08, 1));
  points = shapes::joined(points, clump(12, {1.5, 0, 0}, 0.08, 2));
  return shapes::joined(points, clump(40, {0, -1.4, 0}, 0.06, 3));
}

std::size_t count_kept(const RobustSamples& samples, std::size_t begin, std::size_t end) {
  std::size_t count = 0;
  for (std::size_t i = begin; i < end; ++i) count += samples.kept[PointId(i)];
  return count;
}

std::vector<VertexId> all_vertices(const Triangulation& t) {
  std::vector<VertexId> vertices;
  for (const VertexId v : t.vertices()) vertices.push_back(v);
  return vertices;
}

TEST(SampleParts, HangTogetherWithinReachOfBoth) {
  const std::vector<Point> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 3}, {0, 0, 4}};
  const Triangulation t = delaunay(points).triangulation;
  const auto at = [&](std::size_t p) { return t.vertex_of_point()[PointId(p)]; };
  IdVector<VertexId, double> reach(t.num_vertices(), 3.0);
  reach[at(4)] = 1;
  EXPECT_EQ(sample_parts(t, reach).largest, 5U);
  reach[at(0)] = 2.9;
  const SampleParts two = sample_parts(t, reach);
  EXPECT_EQ(two.largest, 3U);
  EXPECT_EQ(two.part[at(3)], two.part[at(4)]);
  EXPECT_NE(two.part[at(3)], two.part[at(0)]);
  VertexSet apart(t.num_vertices(), 0);
  apart[at(3)] = 1;
  EXPECT_EQ(sample_parts(t, reach, apart).size[at(3)], 1U);
}

// Two close samples reach the others by the spacing of these.
TEST(SampleParts, UsualSpacingIsThatOfTheNeighborsAtLeast) {
  std::vector<Point> points = gallery::integer_grid(5);
  points.push_back({2, 2, 2.01});
  const Triangulation t = delaunay(points).triangulation;
  const VertexStars stars = vertex_stars(t);
  const IdVector<VertexId, double> own = sample_spacing(t, stars, 1);
  const IdVector<VertexId, double> usual = usual_spacing(t, stars, own, all_vertices(t));
  for (const VertexId v : t.vertices()) EXPECT_EQ(usual[v], 1);
  EXPECT_NEAR(own[t.vertex_of_point()[PointId(points.size() - 1)]], 0.01, 1e-9);
}

TEST(FloatingClumps, GoAndTheBodyStays) {
  const std::vector<Point> points = body_with_clumps();
  const std::size_t clean = body().size();
  const RobustResult result = reconstruct_robust(points);
  const MeshReport report = mesh_check(result.surface.mesh);
  EXPECT_TRUE(report.is_closed_manifold());
  EXPECT_EQ(report.components, 1U);
  EXPECT_EQ(report.euler, 2);
  EXPECT_EQ(result.noise.clumps, 3U);
  EXPECT_GE(result.noise.clump_samples, 76U);
  EXPECT_GT(result.noise.largest_clump, 10U);
  EXPECT_GE(result.noise.largest_clump_at.index(), clean);
  EXPECT_EQ(count_kept(robust_samples(points), 0, clean), clean);

  const RobustResult all = reconstruct_robust(points, {.clump_share = 0});
  EXPECT_EQ(all.noise.clumps + all.noise.clump_samples, 0U);
  EXPECT_TRUE(all.noise.largest_clump_at.is_none());
  EXPECT_GT(mesh_check(all.surface.mesh).components, 2U);
}

// One that touches the body stays, unless it is asked for.
TEST(FloatingClumps, ThoseOnTheSurfaceGoByDepth) {
  const std::vector<Point> points = shapes::joined(body(), clump(40, {0, 0.85, -0.85}, 0.1, 4));
  const std::size_t usual = robust_samples(points).counters.clump_samples;
  const std::size_t deep = robust_samples(points, {.clump_depth = 2}).counters.clump_samples;
  EXPECT_LT(usual, deep);
  EXPECT_GE(deep, 10U);
}

// Of fewer than three in a hundred samples.
TEST(FloatingClumps, ASmallBodyIsNone) {
  for (const std::size_t count : {75U, 90U}) {
    const double radius =
        std::sqrt(static_cast<double>(count) / static_cast<double>(body().size()));
    const RobustResult result =
        reconstruct_robust(shapes::joined(body(), even_ball(count, radius, {2, 1, 0.5})));
    EXPECT_EQ(result.noise.clumps, 0U) << count;
    EXPECT_EQ(mesh_check(result.surface.mesh).components, 2U) << count;
  }
}

// Noise of half the spacing leaves few good samples; they lie among the others.
TEST(FloatingClumps, ALayerOfNoiseIsNone) {
  std::vector<Point> points = shapes::torus(80, 40, 0.4, 0.3, 7);
  Random random(8);
  for (Point& p : points) {
    p = p + 0.03 * Vec3{random.gaussian(), random.gaussian(), random.gaussian()};
  }
  EXPECT_LT(robust_samples(points).counters.clump_samples, points.size() / 100);
}

// Links to the nearest good sample, found by spreading until nothing changes.
TEST(FloatingClumps, AreThoseOfTheirDefinition) {
  const std::vector<Point> points = body_with_clumps();
  const Triangulation t = delaunay(points).triangulation;
  const VertexStars stars = vertex_stars(t);
  const auto spacing = sample_spacing(t, stars, 3);
  const Dual dual = voronoi_dual(t);
  const ReconstructOptions reconstruct;
  const VertexSet good = RoughSurface(t, dual, reconstruct).good();
  for (const std::size_t depth : {0U, 1U, 2U, 5U}) {
    const NoiseOptions options{.clump_depth = depth};
    const FloatingClumps found = floating_clumps(t, stars, spacing, good, options);
    const auto usual = usual_spacing(t, stars, spacing, all_vertices(t));
    const auto linked = [&](VertexId v, VertexId w) {
      return distance(t.point(v), t.point(w)) <= 2 * std::min(usual[v], usual[w]);
    };
    IdVector<VertexId, std::size_t> links(t.num_vertices(), points.size());
    IdVector<VertexId, VertexId> first(t.num_vertices());  // of those together without good ones
    for (const VertexId v : t.vertices()) {
      first[v] = v;
      if (good[v] != 0) links[v] = 0;
    }
    for (bool changed = true; changed;) {
      changed = false;
      for (const CellId c : t.finite_cells()) {
        for (const VertexId v : t.cell(c).vertices) {
          for (const VertexId w : t.cell(c).vertices) {
            if (v == w || !linked(v, w)) continue;
            const bool nearer = links[w] + 1 < links[v];
            const bool earlier = good[v] == 0 && good[w] == 0 && first[w] < first[v];
            if (nearer) links[v] = links[w] + 1;
            if (earlier) first[v] = first[w];
            changed = changed || nearer || earlier;
          }
        }
      }
    }
    IdVector<VertexId, std::size_t> size(t.num_vertices(), 0);
    for (const VertexId v : t.vertices()) ++size[first[v]];
    for (const VertexId v : t.vertices()) {
      const std::size_t together = size[first[v]];
      const bool out = links[v] > depth && together > 3 && 50 * together < t.num_vertices();
      EXPECT_EQ(found.out[v] != 0, out) << depth;
    }
    EXPECT_EQ(found.samples,
              static_cast<std::size_t>(std::count(found.out.begin(), found.out.end(), 1)));
    EXPECT_GT(found.samples, 0U);
  }
}

TEST(FloatingClumps, NeitherOrderNorThreadsNorAxesMatter) {
  const std::vector<Point> points = body_with_clumps();
  const RobustSamples expected = robust_samples(points);
  EXPECT_EQ(robust_samples(points, {}, {}, {.threads = 3}).kept, expected.kept);
  std::vector<Point> turned;
  for (auto p = points.rbegin(); p != points.rend(); ++p) turned.push_back({p->y, p->z, p->x});
  RobustSamples other = robust_samples(turned);
  std::reverse(other.kept.begin(), other.kept.end());
  EXPECT_EQ(other.kept, expected.kept);
  EXPECT_EQ(other.counters.clumps, expected.counters.clumps);
  EXPECT_EQ(other.counters.largest_clump, expected.counters.largest_clump);
}

}  // namespace
}  // namespace cocoon
