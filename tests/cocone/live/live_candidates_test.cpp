// What is kept up to date is what the stages give from scratch, whatever the history.
#include "cocone/live/live_candidates.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "cocone/facets/cell_order.h"
#include "cocone/reconstruct.h"
#include "cocone/steps/reconstruct_and_keep.h"
#include "delaunay/delaunay.h"
#include "geom/random/random.h"
#include "io/mesh_file.h"
#include "tests/gallery.h"
#include "tests/long_tests.h"

namespace cocoon {
namespace {

using Corners = std::array<Point, 3>;

struct Sample {
  Vec3 normal;
  bool boundary;
  bool umbrella;
  friend bool operator==(const Sample&, const Sample&) = default;
};

// All that is known, by coordinates.
struct Knowledge {
  std::map<Point, Sample> samples;
  std::set<Corners> left;
};

Knowledge knowledge_of(const DynamicDelaunay& delaunay, const LiveCandidates& live) {
  Knowledge known;
  const TriangulationView view = delaunay.view();
  for (const VertexId v : id_range<VertexId>(delaunay.num_vertex_slots())) {
    if (!delaunay.contains(v)) continue;
    known.samples[view.point(v)] = {live.normal(v), live.is_boundary(v), live.has_umbrella(v)};
  }
  for (const CellId c : view.cell_slots()) {
    EXPECT_TRUE(!view.is_free(c) || live.left(c) == 0);
    for (int i = 0; i < 4; ++i) {
      if (((live.left(c) >> i) & 1U) == 0) continue;
      known.left.insert(sorted_corners(view, facet_id(c, i)));
      const FacetId mirror = view.mirror(facet_id(c, i));
      EXPECT_NE((live.left(cell_of(mirror)) >> index_of(mirror)) & 1U, 0U);
    }
  }
  return known;
}

Knowledge from_scratch(const std::vector<Point>& points, const ReconstructOptions& options,
                       ReconstructCounters& counters, ReconstructStages& stages) {
  Triangulation triangulation = delaunay(points).triangulation;
  counters =
      reconstruct_and_keep(std::move(triangulation), points, {}, options, {}, stages).counters;
  Knowledge known;
  const Triangulation& t = stages.triangulation;
  for (const VertexId v : t.vertices()) {
    known.samples[t.point(v)] = {stages.poles.normals[v], stages.boundary.boundary[v] != 0,
                                 stages.umbrella[v] != 0};
  }
  stages.left.for_each(t, [&](FacetId f) { known.left.insert(sorted_corners(t, f)); });
  return known;
}

void expect_same(const DynamicDelaunay& delaunay, const LiveCandidates& live,
                 const ReconstructOptions& options) {
  std::vector<Point> points;
  for (const VertexId v : id_range<VertexId>(delaunay.num_vertex_slots())) {
    if (delaunay.contains(v)) points.push_back(delaunay.point(v));
  }
  ReconstructCounters expected;
  ReconstructStages stages;
  const Knowledge wanted = from_scratch(points, options, expected, stages);
  const Knowledge known = knowledge_of(delaunay, live);
  EXPECT_EQ(known.samples.size(), wanted.samples.size());
  EXPECT_TRUE(known.samples == wanted.samples);
  EXPECT_EQ(known.left.size(), wanted.left.size());
  EXPECT_TRUE(known.left == wanted.left);
  ReconstructCounters counters;
  live.count(counters);
  EXPECT_EQ(counters.hull_vertices, expected.hull_vertices);
  EXPECT_EQ(counters.degenerate_poles, expected.degenerate_poles);
  EXPECT_EQ(counters.exact_centers, expected.exact_centers);
  EXPECT_EQ(counters.dual_facet_fallbacks, expected.dual_facet_fallbacks);
  EXPECT_EQ(counters.boundary_samples, expected.boundary_samples);
  EXPECT_EQ(counters.ratio_failed, expected.ratio_failed);
  EXPECT_EQ(counters.recovered_samples, expected.recovered_samples);
  EXPECT_EQ(counters.candidates, expected.candidates);
  EXPECT_EQ(counters.pruned, expected.pruned);
  EXPECT_EQ(counters.umbrellas, expected.umbrellas);
  EXPECT_EQ(live.num_finite_cells(), stages.triangulation.num_finite_cells());
}

// What changed() leaves out is as it was.
void expect_unchanged_elsewhere(const Knowledge& before, const Knowledge& after,
                                const std::vector<Point>& changed) {
  const std::set<Point> touched(changed.begin(), changed.end());
  const auto is_touched = [&](const Corners& corners) {
    return std::any_of(corners.begin(), corners.end(),
                       [&](const Point& p) { return touched.contains(p); });
  };
  for (const Corners& corners : after.left) {
    EXPECT_TRUE(is_touched(corners) || before.left.contains(corners));
  }
  for (const auto& [point, sample] : after.samples) {
    if (touched.contains(point)) continue;
    ASSERT_TRUE(before.samples.contains(point));
    EXPECT_EQ(sample.boundary, before.samples.at(point).boundary);
    EXPECT_EQ(sample.umbrella, before.samples.at(point).umbrella);
  }
}

// Removes points near a random one, and puts some of the first ones back, or others beside them.
void run_steps(const std::vector<Point>& points, double reach, double noise, std::size_t count,
               const ReconstructOptions& options = {}) {
  const std::size_t steps = count * test::long_factor();
  Random random(11);
  DynamicDelaunay delaunay(cocoon::delaunay(points).triangulation);
  LiveCandidates live(effective_options(options));
  {
    ReconstructCounters counters;
    ReconstructStages stages;
    from_scratch(points, options, counters, stages);
    delaunay = DynamicDelaunay(std::move(stages.triangulation));
    live.start(delaunay, stages);
  }
  expect_same(delaunay, live, options);
  for (std::size_t step = 0; step < steps; ++step) {
    SCOPED_TRACE("step " + std::to_string(step));
    std::vector<VertexId> vertices;
    for (const VertexId v : id_range<VertexId>(delaunay.num_vertex_slots())) {
      if (delaunay.contains(v)) vertices.push_back(v);
    }
    const Point center = delaunay.point(vertices[random.below(vertices.size())]);
    std::vector<VertexId> removed;
    std::vector<Point> inserted;
    for (const VertexId v : vertices) {
      if (distance(delaunay.point(v), center) > reach) continue;
      if (random.below(3) != 0) removed.push_back(v);
    }
    for (const Point& p : points) {
      if (distance(p, center) > reach || random.below(3) == 0) continue;
      inserted.push_back(p + noise * random.uniform() * random.on_unit_sphere());
    }
    const Knowledge before = knowledge_of(delaunay, live);
    const DelaunayChange change = delaunay.replace(removed, inserted);
    live.update(delaunay, change);
    expect_same(delaunay, live, options);
    std::vector<Point> changed;
    for (const VertexId v : live.changed()) changed.push_back(delaunay.point(v));
    expect_unchanged_elsewhere(before, knowledge_of(delaunay, live), changed);
    if (::testing::Test::HasFailure()) return;
  }
}

TEST(LiveCandidates, OnASphere) { run_steps(gallery::even_sphere(600), 0.4, 0.02, 20); }

TEST(LiveCandidates, OnANoisySphere) {
  Random random(2);
  std::vector<Point> points = gallery::even_sphere(500);
  for (Point& p : points) p = p * (1 + 0.1 * random.uniform());
  run_steps(points, 0.5, 0.1, 20);
}

TEST(LiveCandidates, OnATorusWithTheCoconesRadius) {
  ReconstructOptions options = open_cloud_defaults();
  run_steps(gallery::displaced_torus(700, 1, 0), 0.5, 0.05, 15, options);
}

TEST(LiveCandidates, OnABoxOfLattices) { run_steps(gallery::box_faces(6), 0.5, 0, 20); }

TEST(LiveCandidates, OnABoxWithRoughFaces) { run_steps(gallery::box_faces(6), 0.5, 0.05, 20); }

TEST(LiveCandidates, OnAPartOfMachinery) {
  const TriangleMesh part = read_mesh(std::string(COCOON_TEST_DATA) + "/models/anchor_dense.off");
  double reach = 0;
  for (const Point& p : part.points) reach = std::max(reach, distance(p, part.points[VertexId(0)]));
  run_steps(part.points.raw(), 0.1 * reach, 0.005 * reach, 12);
}

}  // namespace
}  // namespace cocoon
