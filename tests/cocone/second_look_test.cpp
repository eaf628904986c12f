// Two blocks one over the other, so close that samples of one take those of the other for
// neighbors: marks contradict each other, and there is a second look.
#include "cocone/second_look.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <gtest/gtest.h>
#include <limits>
#include <string>
#include <vector>

#include "cocone/reconstruct.h"
#include "geom/errors.h"
#include "geom/random/random.h"
#include "tests/cocone/changing_points.h"
#include "tests/cocone/sample_shapes.h"
#include "tests/stop_after.h"

namespace cocoon {
namespace {

constexpr double far_end = 12;  // of the blocks, along x and y
constexpr double middle = 5;    // where the gap begins
constexpr double top = 10;

// A grid of about one sample per unit of area on the face of a box at `value` of an axis; each is
// moved by up to 0.3 in the face.
void add_face(std::array<double, 3> low, std::array<double, 3> high, std::size_t axis, double value,
              Random& random, std::vector<Point>& points) {
  const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
  const double columns = std::round(high[u] - low[u]);
  const double rows = std::round(high[v] - low[v]);
  for (double i = 0.5; i < columns; ++i) {
    for (double k = 0.5; k < rows; ++k) {
      std::array<double, 3> p{};
      p[axis] = value;
      p[u] = low[u] + (i + random.uniform(-0.3, 0.3)) * (high[u] - low[u]) / columns;
      p[v] = low[v] + (k + random.uniform(-0.3, 0.3)) * (high[v] - low[v]) / rows;
      points.push_back({p[0], p[1], p[2]});
    }
  }
}

std::vector<Point> blocks(double gap, std::uint64_t seed) {
  Random random(seed);
  std::vector<Point> points;
  for (const bool upper : {false, true}) {
    const std::array<double, 3> low = {0, 0, upper ? middle + gap : 0};
    const std::array<double, 3> high = {far_end, far_end, upper ? top : middle};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      add_face(low, high, axis, low[axis], random, points);
      add_face(low, high, axis, high[axis], random, points);
    }
  }
  return points;
}

ReconstructResult first_look(Points points) {
  return reconstruct_tight(points, {.second_look = {.enabled = false}});
}

// So many pairs of blocks, of several gaps.
template <class Visit>
void for_each_pair_of_blocks(Visit visit) {
  for (const double gap : {0.2, 0.3, 0.4}) {
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      SCOPED_TRACE("gap " + std::to_string(gap) + ", seed " + std::to_string(seed));
      visit(blocks(gap, seed));
    }
  }
}

TEST(SecondLook, TakesTheSurfaceThatContradictsItselfLess) {
  const SecondLookOptions defaults;
  std::size_t taken = 0, not_taken = 0, not_asked = 0;
  const auto compare_looks = [&](const std::vector<Point>& points) {
    const ReconstructResult first = first_look(points);
    const ReconstructResult result = reconstruct_tight(points);
    ReconstructOptions strict;
    strict.boundary.radius_mode = RadiusMode::cocone;
    const ReconstructResult second = reconstruct_tight(points, strict);
    const std::size_t conflicts = first.counters.marking_conflicts;
    if (!calls_for_second_look(defaults, {conflicts, 0, points.size()})) {
      EXPECT_EQ(result.counters.first_conflicts, 0U);
      EXPECT_EQ(result.mesh, first.mesh);
      ++not_asked;
      return;
    }
    EXPECT_EQ(result.counters.first_conflicts, conflicts);
    const bool is_better = second.counters.marking_conflicts < conflicts;
    EXPECT_EQ(result.counters.second_look, is_better ? 1U : 0U);
    EXPECT_EQ(result.mesh, is_better ? second.mesh : first.mesh);
    EXPECT_EQ(result.contradicted, is_better ? second.contradicted : first.contradicted);
    EXPECT_EQ(result.normals, is_better ? second.normals : first.normals);
    ++(is_better ? taken : not_taken);
  };
  for_each_pair_of_blocks(compare_looks);
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    SCOPED_TRACE("gap 0.05, seed " + std::to_string(seed));
    compare_looks(blocks(0.05, seed));
  }
  EXPECT_GT(taken, 2U);
  EXPECT_GT(not_taken, 0U);
  EXPECT_GT(not_asked, 1U);
}

TEST(SecondLook, UsesSamplesThatTheFirstLeavesOut) {
  std::size_t before = 0, after = 0;
  for_each_pair_of_blocks([&](const std::vector<Point>& points) {
    before += first_look(points).unused_points;
    after += reconstruct_tight(points).unused_points;
  });
  EXPECT_LT(2 * after, before);
}

TEST(SecondLook, IsVerifiedIfAskedFor) {
  const ReconstructResult result = reconstruct_tight(blocks(0.2, 1), {.verify = true});
  EXPECT_EQ(result.counters.second_look, 1U);
  EXPECT_EQ(result.status, SurfaceStatus::ok);
  EXPECT_TRUE(result.verification.ok());
  EXPECT_FALSE(result.mesh.triangles.empty());
}

TEST(SecondLook, ThereIsNoneWithOptionsThatLeaveItOut) {
  const std::vector<Point> points = blocks(0.2, 1);
  std::vector<ReconstructOptions> options(4);
  options[0].mode = Mode::paper;
  options[1].boundary.radius_mode = RadiusMode::cocone;
  options[2].clean_up.enabled = false;
  options[3].second_look.max_conflicts = 1000;
  for (const ReconstructOptions& without : options) {
    const ReconstructResult result = reconstruct_tight(points, without);
    EXPECT_EQ(result.counters.first_conflicts, 0U);
    EXPECT_EQ(result.counters.second_look, 0U);
  }
}

TEST(SecondLook, FollowsWhenConflictsAreMoreThanBothLimits) {
  const SecondLookOptions options{.max_conflicts = 5, .max_conflict_share = 0.001};
  EXPECT_FALSE(calls_for_second_look(options, {5, 0, 100}));
  EXPECT_TRUE(calls_for_second_look(options, {6, 0, 100}));
  EXPECT_FALSE(calls_for_second_look(options, {10, 0, 10'000}));
  EXPECT_TRUE(calls_for_second_look(options, {11, 0, 10'000}));
  EXPECT_FALSE(calls_for_second_look({.enabled = false}, {1000, 0, 1000}));
}

TEST(SecondLook, PartsHandlesAndUnusedSamplesCostWhatTheCleanUpSays) {
  CleanUpOptions costs;
  costs.component_cost = 100;
  costs.handle_cost = 30;
  costs.unused_cost = 7;
  EXPECT_EQ(cost_of({.parts = 2, .twice_handles = 3, .unused_vertices = 4}, costs), 273);
  costs.handle_cost = std::numeric_limits<double>::infinity();
  EXPECT_EQ(cost_of({.parts = 1}, costs), 100);
  EXPECT_EQ(cost_of({.parts = 1, .twice_handles = 2}, costs), 100 + 0x1p20);
}

// As of a foreign mesh: what it tells is right here, in all cells.
KnownLabels told_by_blocks(const Triangulation& triangulation, double gap) {
  KnownLabels known;
  known.labels = IdVector<CellId, CellLabel>(triangulation.num_cells(), CellLabel::unmarked);
  for (const CellId c : triangulation.finite_cells()) {
    Vec3 sum{};
    for (const VertexId v : triangulation.cell(c).vertices) sum = sum + triangulation.point(v);
    const Vec3 p = 0.25 * sum;
    const bool is_aside = p.x < 0 || p.y < 0 || p.x > far_end || p.y > far_end;
    const bool is_in = !is_aside && p.z > 0 && p.z < top && (p.z < middle || p.z > middle + gap);
    known.labels[c] = is_in ? CellLabel::in : CellLabel::out;
    if (known.undisturbed.empty()) known.undisturbed.push_back(c);
  }
  return known;
}

// Where the marking may be done again without such a mesh, both surfaces are closed.
TEST(SecondLook, WhereOthersTellItMustCostLessToo) {
  std::size_t taken = 0, asked = 0;
  for (const double gap : {0.1, 0.2, 0.3}) {
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      SCOPED_TRACE("gap " + std::to_string(gap) + ", seed " + std::to_string(seed));
      const std::vector<Point> points = blocks(gap, seed);
      const auto result_with = [&](const ReconstructOptions& options) {
        return reconstruct_tight_with_labels(
            points, [&](const Triangulation& t, const auto&...) { return told_by_blocks(t, gap); },
            options);
      };
      const ReconstructResult first = result_with({.second_look = {.enabled = false}});
      ReconstructOptions strict;
      strict.boundary.radius_mode = RadiusMode::cocone;
      const ReconstructResult second = result_with(strict);
      const ReconstructResult result = result_with({});
      const auto cost = [](const ReconstructResult& of) {
        return cost_of(surface_roughness(of.mesh, of.vertices), {});
      };
      const std::size_t conflicts = first.counters.marking_conflicts;
      const bool is_asked = calls_for_second_look({}, {conflicts, 0, points.size()}) &&
                            cost(first) > cost_of({.parts = 1}, {});
      EXPECT_EQ(result.counters.first_conflicts, is_asked ? conflicts : 0U);
      const bool is_better =
          is_asked && second.counters.marking_conflicts < conflicts && cost(second) < cost(first);
      EXPECT_EQ(result.counters.second_look, is_better ? 1U : 0U);
      EXPECT_EQ(result.mesh, is_better ? second.mesh : first.mesh);
      asked += is_asked ? 1U : 0U;
      taken += is_better ? 1U : 0U;
    }
  }
  EXPECT_GT(asked, 0U);
  EXPECT_GT(taken, 0U);
}

TEST(SecondLook, OptionsOutOfRangeAreRefused) {
  for (const double wrong : {-1.0, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_THROW(reconstruct_tight(blocks(0.2, 1), {.second_look = {.max_poor_per_sample = wrong}}),
                 InputError);
  }
}

TEST(SecondLook, DoesNotFollowWhereTheCleanUpDecidesMost) {
  EXPECT_TRUE(calls_for_second_look({.max_poor_per_sample = 2}, {100, 200, 100}));
  EXPECT_FALSE(calls_for_second_look({.max_poor_per_sample = 2}, {100, 201, 100}));
  // Noise of 90 % of the spacing.
  std::vector<Point> points = shapes::noisy_sphere(2000, 0.035, 1);
  const ReconstructResult result = reconstruct_tight(points);
  EXPECT_GT(result.counters.marking_conflicts, 5U);
  EXPECT_EQ(result.counters.first_conflicts, 0U);
  EXPECT_EQ(result.mesh, first_look(points).mesh);
}

// Points come and go at either block: also where there is no second look any more, and where there
// is one again.
TEST(SecondLook, IsThatOfStartingOverAfterEachChange) {
  std::size_t taken = 0, left = 0;
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    Random random(seed);
    ChangingPoints changing(blocks(0.25, seed));
    DynamicTightCocone cocone;
    expect_equal_reconstruction(cocone.reconstruct(changing.points),
                                reconstruct_tight(changing.points));
    for (int step = 0; step < 12; ++step) {
      SCOPED_TRACE("seed " + std::to_string(seed) + ", step " + std::to_string(step));
      const std::vector<Point> other = blocks(0.15 + 0.15 * (step % 5), 10 + random.below(100));
      const double x = random.uniform(0, far_end), y = random.uniform(0, far_end);
      const auto is_near = [&](const Point& p) {
        return std::abs(p.x - x) < 4 && std::abs(p.y - y) < 4 && p.z > 3;
      };
      std::vector<Point> added;
      for (const Point& p : other) {
        if (is_near(p)) added.push_back(p);
      }
      changing.change(is_near, added);
      ReconstructResult expected;
      is_local_and_equal(cocone, changing, expected);
      ++(expected.counters.second_look != 0 ? taken : left);
    }
  }
  EXPECT_GT(taken, 3U);
  EXPECT_GT(left, 3U);
}

// Wherever it is cancelled, in either look, the points before are there again.
TEST(SecondLook, CancelledInItTheSurfaceBeforeStays) {
  const ChangingPoints before(blocks(0.2, 1));
  ASSERT_EQ(reconstruct_tight(before.points).counters.second_look, 1U);
  for (const char* stage : {"second_look/poles", "second_look/cocone/surface",
                            "second_look/tight/marks", "second_look/tight/body"}) {
    SCOPED_TRACE(stage);
    DynamicTightCocone cocone;
    cocone.reconstruct(before.points);
    ChangingPoints changing = before;
    changing.change([](const Point& p) { return p.z > 9.5 && p.x < 4; }, {});
    test::StopIn stop(stage);
    EXPECT_THROW(cocone.replace(changing.points, changing.old_position, {1, &stop}), Cancelled);
    changing = before;
    changing.change([](const Point&) { return false; }, {});
    ReconstructResult expected;
    is_local_and_equal(cocone, changing, expected);
    EXPECT_EQ(expected.counters.second_look, 1U);
  }
}

}  // namespace
}  // namespace cocoon
