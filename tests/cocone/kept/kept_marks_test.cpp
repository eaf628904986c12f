// Marks that go on from those before are the ones of mark_cells, whatever the history.
#include "cocone/kept/kept_marks.h"

#include <gtest/gtest.h>
#include <string>
#include <utility>
#include <vector>

#include "cocone/extract_manifold.h"
#include "cocone/live/known_candidates.h"
#include "cocone/mark_cells.h"
#include "geom/random/random.h"
#include "tests/cocone/kept/live_samples.h"
#include "tests/cocone/sample_shapes.h"
#include "tests/gallery.h"
#include "tests/long_tests.h"

namespace cocoon {
namespace {

class LiveMarks {
 public:
  explicit LiveMarks(const std::vector<Point>& points, const GoodVertexOptions& options = {})
      : options_(options), samples_(points) {}

  void change(double reach, const std::vector<Point>& others, Random& random) {
    samples_.change(reach, others, random, [&](const auto& what) { follow(what); });
  }

  // All beyond a distance from the origin go.
  void remove_beyond(double reach) {
    std::vector<VertexId> removed;
    for (const VertexId v : id_range<VertexId>(samples_.delaunay().num_vertex_slots())) {
      if (norm(samples_.delaunay().point(v)) > reach) removed.push_back(v);
    }
    samples_.replace(removed, {}, [&](const auto& what) { follow(what); });
  }

  void expect_marks_of_the_stage() {
    samples_.lend([&](const Triangulation& triangulation) { compare(triangulation); });
  }

  std::size_t local_marks() const { return kept_.local_marks(); }

 private:
  void follow(const DelaunayChange& change) {
    if (kept_.exists()) kept_.update(samples_.delaunay(), change, samples_.candidates());
  }
  void follow(const Renumbering& renumbering) {
    if (kept_.exists()) kept_.renumber(renumbering, samples_.delaunay());
  }

  void compare(const Triangulation& triangulation) {
    const KnownCandidates known = known_candidates(samples_.candidates());
    LinkedFacets left = link_facets(triangulation, candidates_left(samples_.candidates()));
    const LinkedFacets surface =
        extract_manifold(triangulation, std::move(left), known.umbrella).triangles;
    const CellMarks actual = kept_.mark(triangulation, samples_.delaunay().cells_at_vertices(),
                                        surface, known.boundary, {}, options_);
    const CellMarks expected = mark_cells(triangulation, surface, known.boundary, options_);
    ASSERT_EQ(actual.labels, expected.labels);
    ASSERT_EQ(actual.good, expected.good);
    ASSERT_EQ(actual.visited, expected.visited);
    ASSERT_EQ(actual.folded, expected.folded);
    ASSERT_EQ(actual.good_vertices, expected.good_vertices);
    ASSERT_EQ(actual.visited_vertices, expected.visited_vertices);
    ASSERT_EQ(actual.rounds, expected.rounds);
    ASSERT_EQ(actual.conflicts, expected.conflicts);
    ASSERT_EQ(actual.known_cells, expected.known_cells);
  }

  GoodVertexOptions options_;
  LiveSamples samples_;
  KeptMarks kept_;
};

// Returns the share of changes whose marks went on from those before.
double run_steps(const std::vector<Point>& points, const std::vector<Point>& others, double reach,
                 std::size_t count, const GoodVertexOptions& options = {}) {
  const std::size_t steps = count * test::long_factor();
  Random random(21);
  LiveMarks live(points, options);
  live.expect_marks_of_the_stage();
  for (std::size_t step = 0; step < steps; ++step) {
    SCOPED_TRACE("step " + std::to_string(step));
    live.change(reach, others, random);
    live.expect_marks_of_the_stage();
    if (testing::Test::HasFatalFailure()) return 0;
  }
  return static_cast<double>(live.local_marks()) / static_cast<double>(steps);
}

TEST(KeptMarks, OnRandomSamples) {
  EXPECT_GT(run_steps(shapes::sphere(1500, 3), shapes::sphere(1500, 4), 0.3, 30), 0.8);
}

// Rims, and cells without a good vertex.
TEST(KeptMarks, OnATornSurface) {
  EXPECT_GT(run_steps(shapes::cut_sphere(1500, 0.5, 2), shapes::cut_sphere(1500, 0.5, 5), 0.3, 30),
            0.8);
}

// More and more noise: soon marks contradict each other, and there is nothing to go on from.
TEST(KeptMarks, OnNoise) {
  const double share = run_steps(
      shapes::noisy_sphere(1500, 0.01, 3),
      shapes::joined(shapes::noisy_sphere(750, 0.005, 4), shapes::noisy_sphere(750, 0.018, 4)), 0.3,
      60);
  EXPECT_GT(share, 0);
  EXPECT_LT(share, 0.95);
}

// Parts of the surface that the hull sees one by one.
TEST(KeptMarks, OnSeveralBodies) {
  const auto bodies = [](std::uint64_t seed) {
    return shapes::joined(shapes::sphere(700, seed),
                          shapes::moved(shapes::sphere(700, seed + 1), {2.2, 0, 0}));
  };
  EXPECT_GT(run_steps(bodies(3), bodies(5), 0.4, 30), 0.8);
}

// A surface in the body that the hull does not see comes and goes: no marks reach it.
TEST(KeptMarks, WhereASurfaceIsNotReached) {
  const std::vector<Point> outer = shapes::sphere(1000, 3);
  const std::vector<Point> both = shapes::joined(outer, shapes::sphere(400, 4, 0.4));
  run_steps(both, both, 0.7, 30);
}

// The hull sees a surface only when what is around it has gone: then it has marks everywhere.
TEST(KeptMarks, WhereASurfaceIsReachedLater) {
  std::vector<Point> points = shapes::sphere(500, 3);
  for (const double x : {-3.0, 3.0}) {
    for (const double y : {-3.0, 3.0}) points.insert(points.end(), {{x, y, -3}, {x, y, 3}});
  }
  LiveMarks live(points);
  live.expect_marks_of_the_stage();
  live.remove_beyond(2);
  live.expect_marks_of_the_stage();
}

TEST(KeptMarks, OnABox) {
  EXPECT_GT(run_steps(gallery::box_faces(7), gallery::box_faces(9), 0.4, 20), 0.3);
}

// Labels found anew that do not fit: the parts of the surface contradict each other.
TEST(KeptMarks, OnFewNoisySamples) {
  EXPECT_GT(
      run_steps(shapes::noisy_sphere(300, 0.03, 3), shapes::noisy_sphere(300, 0.03, 4), 0.5, 60),
      0.5);
}

TEST(KeptMarks, OnBoxesThatTouch) {
  const std::vector<Point> box = shapes::cube_grid(5);
  EXPECT_GT(run_steps(shapes::joined(box, shapes::moved(box, {5, 0, 0})),
                      shapes::joined(box, shapes::moved(box, {5, 5, 0})), 2.5, 60),
            0.3);
}

// Where nearly every edge is a crease, a sample that is no longer interior is no longer good,
// though nothing has changed at it.
TEST(KeptMarks, WhereLabelsOfSamplesDecide) {
  EXPECT_GT(
      run_steps(shapes::sphere(120, 3), shapes::sphere(120, 4), 0.8, 100, {.crease_cosine = -0.95}),
      0.8);
}

}  // namespace
}  // namespace cocoon
