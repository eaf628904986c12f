// What a changing set of points keeps of its surface is what starting over gives, and where the
// surface is certain the stages do not run over the whole.
#include "cocone/dynamic_tight_cocone.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <iterator>
#include <optional>
#include <string>
#include <vector>

#include "geom/arrays/list_edit.h"
#include "geom/errors.h"
#include "geom/mesh_check.h"
#include "geom/random/random.h"
#include "tests/cocone/changing_points.h"
#include "tests/cocone/equal_reconstructions.h"
#include "tests/cocone/sample_shapes.h"
#include "tests/gallery.h"
#include "tests/long_tests.h"
#include "tests/stop_after.h"

namespace cocoon {
namespace {

// A sample of a sphere with noise, in units of the spacing.
Point rough_sample(std::size_t n, double noise, Random& random) {
  return random.on_unit_sphere() + noise * spacing_on_sphere(n) * random.on_unit_sphere();
}

// How many changes were local, and how many of these with samples of each kind.
struct LocalChanges {
  std::size_t all = 0;
  std::size_t with_boundary = 0;
  std::size_t with_unused = 0;
  std::size_t with_folds = 0;
};

// Within some spacings of random samples half of the points go, others come.
LocalChanges change_here_and_there(std::vector<Point> points, double noise, std::uint64_t seed) {
  const std::size_t n = points.size();
  Random random(seed);
  ChangingPoints changing(std::move(points));
  DynamicTightCocone cocone;
  cocone.reconstruct(changing.points);
  LocalChanges local;
  const std::size_t steps = 40 * test::long_factor();
  for (std::size_t step = 0; step < steps; ++step) {
    SCOPED_TRACE("seed " + std::to_string(seed) + ", step " + std::to_string(step));
    const Point center = changing.points[random.below(changing.points.size())];
    const double reach = spacing_on_sphere(n) * (1 + 2 * random.uniform());
    std::vector<Point> added;
    for (std::size_t i = 0; i < n; ++i) {
      const Point p = rough_sample(n, noise, random);
      if (distance(p, center) < reach && random.below(2) == 0) added.push_back(p);
    }
    changing.change(
        [&](const Point& p) { return distance(p, center) < reach && random.below(2) == 0; }, added);
    ReconstructResult expected;
    const bool is_local = is_local_and_equal(cocone, changing, expected);
    if (::testing::Test::HasFailure()) return local;
    if (!is_local) continue;
    ++local.all;
    local.with_boundary += expected.counters.boundary_samples > 0 ? 1U : 0U;
    local.with_unused += expected.unused_points > 0 ? 1U : 0U;
    local.with_folds += expected.counters.demoted_vertices > 0 ? 1U : 0U;
  }
  return local;
}

LocalChanges operator+(const LocalChanges& a, const LocalChanges& b) {
  return {a.all + b.all, a.with_boundary + b.with_boundary, a.with_unused + b.with_unused,
          a.with_folds + b.with_folds};
}

// Boundary samples, samples off the surface and folds are no reason to look at the whole.
TEST(DynamicTightCocone, RoughSpheresChangeLocally) {
  LocalChanges local;
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U, 5U}) {
    Random random(seed);
    std::vector<Point> points(300);
    for (Point& p : points) p = rough_sample(points.size(), 0.1, random);
    local = local + change_here_and_there(std::move(points), 0.1, seed);
    if (HasFailure()) return;
  }
  EXPECT_GT(local.all, 60U);
  EXPECT_GT(local.with_boundary, 60U);
  EXPECT_GT(local.with_unused, 20U);
  EXPECT_GT(local.with_folds, 20U);
}

// One of the changes with seed 48 leaves a cell without a good vertex, and nothing else that tells.
TEST(DynamicTightCocone, EvenSpheresChangeLocally) {
  LocalChanges local;
  for (const std::uint64_t seed : {1U, 2U, 48U}) {
    local = local + change_here_and_there(gallery::even_sphere(100), 0.15, seed);
    if (HasFailure()) return;
  }
  EXPECT_GT(local.all, 50U);
}

// Carries an edit out and returns the whole result, if only what it did was told.
std::optional<ReconstructResult> edited(DynamicTightCocone& cocone, const TriangleMesh& before,
                                        const std::vector<Point>& points,
                                        const ListEdit<PointId>& change) {
  DynamicTightCocone::Edited done = cocone.edit(points, change);
  if (!done.edit) return {};
  EXPECT_TRUE(done.result.mesh.triangles.empty());
  TriangleMesh& mesh = done.result.mesh;
  mesh.points = IdVector<VertexId, Point>(points);
  const IdVector<PointId, PointId> after = places_after(change, before.points.size());
  for (const Triangle& t : before.triangles) {
    Triangle now;
    bool stays = true;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto& touched = done.edit->touched;
      stays = stays && !std::binary_search(touched.begin(), touched.end(), t[i]);
      now[i] = VertexId(after[PointId(t[i].value)].value);
    }
    if (stays) mesh.triangles.push_back(now);
  }
  for (const Triangle& t : done.edit->triangles) mesh.triangles.push_back(t);
  canonicalize_triangles(mesh);
  cocone.complete(done.result);
  return std::move(done.result);
}

// How many edits told what they did, of certain surfaces and of others.
struct ToldEdits {
  std::size_t certain = 0;
  std::size_t others = 0;
};

// As change_here_and_there, by edits; each is taken back, and sometimes done again.
ToldEdits edit_here_and_there(std::vector<Point> points, double noise, std::uint64_t seed) {
  const std::size_t n = points.size();
  Random random(seed);
  DynamicTightCocone cocone;
  ReconstructResult expected = cocone.reconstruct(points);
  ToldEdits told;
  const auto edit_and_compare = [&](const std::vector<Point>& next,
                                    const ListEdit<PointId>& change) {
    cocone.look_if_smooth();
    const bool was_smooth = cocone.is_smooth();
    const std::optional<ReconstructResult> actual = edited(cocone, expected.mesh, next, change);
    expected = reconstruct_tight(next, cocone.options());
    if (!actual) return;
    EXPECT_TRUE(was_smooth);
    expect_equal_reconstruction(*actual, expected);
    ++(cocone.is_certain() ? told.certain : told.others);
  };
  for (std::size_t step = 0; step < 30 * test::long_factor(); ++step) {
    SCOPED_TRACE("seed " + std::to_string(seed) + ", step " + std::to_string(step));
    const Point center = points[random.below(points.size())];
    const double reach = spacing_on_sphere(n) * (1 + 2 * random.uniform());
    std::vector<Point> next;
    ListEdit<PointId> change;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (distance(points[i], center) < reach && random.below(2) == 0) {
        change.removed.push_back(PointId(i));
        change.added.push_back(PointId(next.size()));
        next.push_back(points[i] + noise * spacing_on_sphere(n) * random.on_unit_sphere());
      } else {
        next.push_back(points[i]);
      }
    }
    edit_and_compare(next, change);
    const bool stays = random.below(2) == 0;
    if (!stays) edit_and_compare(points, change.reversed());
    if (stays) points = std::move(next);
    if (::testing::Test::HasFailure()) return told;
  }
  return told;
}

// Where the surface is not certain the body tells what an edit did to the mesh.
TEST(DynamicTightCocone, EditsTellWhatTheyDid) {
  ToldEdits told;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const double noise = 0.2 + 0.05 * static_cast<double>(seed % 5);
    Random random(seed);
    std::vector<Point> points = gallery::even_sphere(400);
    for (Point& p : points) p = p + noise * spacing_on_sphere(400) * random.on_unit_sphere();
    const ToldEdits more = edit_here_and_there(std::move(points), 0.2, seed);
    told = {told.certain + more.certain, told.others + more.others};
    if (HasFailure()) return;
  }
  EXPECT_GT(told.certain, 100U);
  EXPECT_GT(told.others, 20U);
}

// Where there is none for a while, edits do not go on from the one before.
TEST(DynamicTightCocone, EditsOfSurfacesThatComeAndGo) {
  ToldEdits told;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    Random random(seed);
    std::vector<Point> points = gallery::even_sphere(60);
    for (Point& p : points) p = p + 0.5 * spacing_on_sphere(60) * random.on_unit_sphere();
    told.others += edit_here_and_there(std::move(points), 0.5, seed).others;
    if (HasFailure()) return;
  }
  EXPECT_GT(told.others, 20U);
}

// What is left without the points that go is flat, so their vertices stay. They have no new cells,
// and an edit would not see them come.
TEST(DynamicTightCocone, PointsThatComeBackAsTheirVerticesAreNotLost) {
  const std::vector<Point> points = gallery::even_sphere(400);
  DynamicTightCocone cocone;
  cocone.reconstruct(points);
  ListEdit<PointId> change;
  for (std::size_t i = 3; i < points.size(); ++i) {
    change.removed.push_back(PointId(i));
    change.added.push_back(PointId(i));
  }
  const DynamicTightCocone::Edited edited = cocone.edit(points, change);
  EXPECT_FALSE(edited.edit.has_value());
  expect_equal_reconstruction(edited.result, reconstruct_tight(points));
}

// The same where labels are known of what stays: such a vertex is new for those who tell them.
TEST(DynamicTightCocone, NothingIsKnownOfPointsThatComeBackAsTheirVertices) {
  std::vector<Point> points = gallery::plane_and_apex(12);
  const std::vector<Point> moved = shapes::moved(points, {0.5, 0.5, 0});
  points.insert(points.end(), moved.begin(), moved.end());
  std::vector<PointId> before;  // the apexes go, and come again
  for (const Point& p : points) before.push_back(p.z == 0 ? PointId(before.size()) : PointId());
  DynamicTightCocone cocone;
  const ReconstructResult first = cocone.reconstruct(points);
  std::vector<KnownTriangle> known;
  std::vector<PointId> torn;
  for (const Triangle& t : first.mesh.triangles) {
    KnownTriangle corners;
    std::transform(t.begin(), t.end(), corners.begin(),
                   [&](VertexId v) { return first.point_of_vertex[v]; });
    if (std::all_of(t.begin(), t.end(), [&](VertexId v) { return first.mesh.points[v].z == 0; })) {
      known.push_back(corners);
    } else {
      torn.insert(torn.end(), corners.begin(), corners.end());
    }
  }
  std::erase_if(torn, [&](PointId p) { return points[p.index()].z != 0; });
  OldSurface old;
  std::size_t asked = 0;
  old.labels = [&](const Triangulation& triangulation, const FacetSet& likely,
                   const Execution& execution) {
    ++asked;
    return known_labels(triangulation, known, likely, execution);
  };
  old.triangles.torn = [&] { return torn; };
  old.triangles.at = [&](std::span<const PointId> at) {
    std::vector<KnownTriangle> found;
    std::copy_if(known.begin(), known.end(), std::back_inserter(found), [&](const auto& t) {
      return std::any_of(t.begin(), t.end(),
                         [&](PointId p) { return std::binary_search(at.begin(), at.end(), p); });
    });
    return found;
  };
  const ReconstructResult again = cocone.replace(points, before, {}, old);
  EXPECT_EQ(asked, 1U);
  expect_equal_reconstruction(again, reconstruct_tight_with_labels(points, old.labels));
  EXPECT_EQ(asked, 2U);
}

// An edit has no mesh to be verified.
TEST(DynamicTightCocone, WhatIsToBeVerifiedIsNoEdit) {
  std::size_t not_certain = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    Random random(seed);
    std::vector<Point> points = gallery::even_sphere(400);
    for (Point& p : points) p = p + 0.3 * spacing_on_sphere(400) * random.on_unit_sphere();
    DynamicTightCocone cocone({.verify = true});
    cocone.reconstruct(points);
    for (std::size_t step = 0; step < 3; ++step) {
      const PointId moved(random.below(points.size()));
      points[moved.index()] =
          points[moved.index()] + 0.1 * spacing_on_sphere(400) * random.on_unit_sphere();
      const DynamicTightCocone::Edited edited = cocone.edit(points, {{moved}, {moved}});
      EXPECT_FALSE(edited.edit.has_value());
      EXPECT_EQ(edited.result.verification.triangles, edited.result.mesh.triangles.size());
      EXPECT_FALSE(edited.result.mesh.triangles.empty());
      not_certain += edited.result.counters.boundary_samples > 0 ? 1U : 0U;
    }
  }
  EXPECT_GT(not_certain, 10U);
}

// Stages over the whole borrow the triangulation, and vertices move into gaps for that: wherever it
// is cancelled, the points before are there again.
TEST(DynamicTightCocone, CancelledOnATornSurfaceItGoesOnFromThePointsBefore) {
  Random random(5);
  std::vector<Point> points;
  while (points.size() < 700) points.push_back(rough_sample(700, 0.5, random));
  ChangingPoints changing(points);
  DynamicTightCocone cocone;
  cocone.reconstruct(changing.points);
  ChangingPoints before = changing;
  const int cancelled = test::stop_everywhere(
      [&](Progress& progress) {
        before = changing;
        changing.change([&](const Point& p) { return p.z > 0.9 || random.below(40) == 0; },
                        {rough_sample(700, 0.5, random), rough_sample(700, 0.5, random)});
        cocone.replace(changing.points, changing.old_position, {1, &progress});
      },
      [&](int n) {
        changing = before;
        changing.change([](const Point&) { return false; }, {});
        ReconstructResult expected;
        EXPECT_FALSE(is_local_and_equal(cocone, changing, expected)) << "after " << n;
        EXPECT_GT(expected.counters.poor_cells, 0U);
      });
  EXPECT_GT(cancelled, 10);
  changing.change([](const Point&) { return false; }, {rough_sample(700, 0.5, random)});
  ReconstructResult expected;
  EXPECT_FALSE(is_local_and_equal(cocone, changing, expected));
}

// Fewer points come than were there, all of them new: ids of vertices before are beyond those
// after.
TEST(DynamicTightCocone, CancelledWhenFewOtherPointsCameItGoesOnFromThePointsBefore) {
  ChangingPoints changing(gallery::even_sphere(300));
  DynamicTightCocone cocone;
  cocone.reconstruct(changing.points);
  const ChangingPoints before = changing;
  changing.change([](const Point&) { return true; }, gallery::even_sphere(20));
  const int cancelled = test::stop_everywhere(
      [&](Progress& progress) {
        cocone.replace(changing.points, changing.old_position, {1, &progress});
      },
      [&](int) {
        ChangingPoints again = before;
        again.change([](const Point&) { return false; }, {});
        ReconstructResult expected;
        is_local_and_equal(cocone, again, expected);
      });
  EXPECT_GT(cancelled, 10);
}

// As delaunay() does.
TEST(DynamicTightCocone, RefusesToHaveNoPoints) {
  ChangingPoints changing(gallery::even_sphere(300));
  DynamicTightCocone cocone;
  cocone.reconstruct(changing.points);
  ASSERT_TRUE(cocone.is_smooth());
  EXPECT_THROW(cocone.replace({}, {}), InputError);
  ListEdit<PointId> all;
  for (std::size_t i = 0; i < changing.points.size(); ++i) all.removed.push_back(PointId(i));
  EXPECT_THROW(cocone.edit({}, all), InputError);
  changing.change([](const Point& p) { return p.x > 0.99; }, {{1, 0, 0}});
  ReconstructResult expected;
  EXPECT_TRUE(is_local_and_equal(cocone, changing, expected));
}

TEST(DynamicTightCocone, RefusesStepsThatDoNotLeadToThePoints) {
  const std::vector<Point> points = gallery::even_sphere(300);
  DynamicTightCocone cocone;
  cocone.reconstruct(points);
  std::vector<Point> fewer(points.begin() + 1, points.end());
  EXPECT_THROW(cocone.edit(fewer, {}), InputError);
  EXPECT_THROW(cocone.edit(fewer, {{PointId(300U)}, {}}), InputError);
  EXPECT_THROW(cocone.edit(points, {{PointId(0U)}, {PointId(300U)}}), InputError);
  // Each but the last is said to have been where it is now.
  std::vector<PointId> old_position;
  for (std::uint32_t i = 0; i < fewer.size(); ++i) old_position.emplace_back(i);
  EXPECT_THROW(cocone.replace(fewer, old_position), InputError);
  old_position[0] = PointId(300U);
  EXPECT_THROW(cocone.replace(fewer, old_position), InputError);
  EXPECT_THROW(cocone.replace(fewer, std::vector<PointId>(3)), InputError);
  fewer.erase(fewer.begin());
  EXPECT_THROW(cocone.edit(fewer, {{PointId(1U), PointId(0U)}, {}}), InputError);
  EXPECT_TRUE(cocone.edit(fewer, {{PointId(0U), PointId(1U)}, {}}).result.status ==
              SurfaceStatus::ok);
  // Nothing is known yet.
  DynamicTightCocone fresh;
  EXPECT_THROW(fresh.edit(points, {{}, {PointId(5U)}}), InputError);
  EXPECT_THROW(fresh.replace(points, std::vector<PointId>(points.size(), PointId(7U))), InputError);
}

// In the same words as from scratch, and of the points, not of the change.
TEST(DynamicTightCocone, RefusesFlatPointsAsAReconstructionDoes) {
  const auto message_of = [](auto run) -> std::string {
    try {
      run();
    } catch (const InputError& error) {
      return error.what();
    }
    return "none";
  };
  ChangingPoints changing(gallery::plane_and_apex(6));
  DynamicTightCocone cocone;
  cocone.reconstruct(changing.points);
  const ChangingPoints before = changing;
  changing.change([](const Point& p) { return p.z > 0; }, {{0.5, 0.5, 0}});
  EXPECT_EQ(message_of([&] { cocone.replace(changing.points, changing.old_position); }),
            message_of([&] { reconstruct_tight(changing.points); }));
  changing = before;
  changing.change([](const Point&) { return false; }, {{0.5, 0.5, 1}});
  ReconstructResult expected;
  is_local_and_equal(cocone, changing, expected);
}

// Nothing is known of the samples then but their triangulation.
// One so far out that squared areas among the others vanish beside it.
TEST(DynamicTightCocone, RefusesPointsOfIncomparableSizesAsAReconstructionDoes) {
  std::vector<Point> points = gallery::even_sphere(300);
  for (Point& p : points) p = 0x1p-101 * p;
  for (const Point& p : {Point{1, 0, 0}, Point{0, 1, 0}, Point{0, 0, 1}}) points.push_back(p);
  DynamicTightCocone cocone;
  cocone.reconstruct(points);
  std::vector<PointId> old_position;
  for (std::size_t i = 0; i < points.size(); ++i) old_position.push_back(PointId(i));
  points.push_back({0x1.fp+99, 0, 0});
  old_position.push_back({});
  EXPECT_THROW(reconstruct_tight(points), InputError);
  EXPECT_THROW(cocone.replace(points, old_position), InputError);
  points.back() = {1, 1, 1};
  EXPECT_NO_THROW(cocone.replace(points, old_position));
}

TEST(DynamicTightCocone, CompletesAResultAfterACancelledChange) {
  Random random(2);
  for (const double noise : {0.0, 0.2}) {
    std::vector<Point> points = gallery::even_sphere(400);
    for (Point& p : points) p = p + noise * spacing_on_sphere(400) * random.on_unit_sphere();
    DynamicTightCocone cocone({.mode = Mode::paper});
    ReconstructResult result = cocone.reconstruct(points);
    const ReconstructResult expected = result;
    ASSERT_EQ(expected.unused_points, 0U);
    const std::vector<Point> fewer(points.begin() + 1, points.end());
    test::StopAfter progress(1);
    EXPECT_THROW(cocone.edit(fewer, {{PointId(0)}, {}}, {1, &progress}), Cancelled);
    cocone.complete(result);
    expect_equal_reconstruction(result, expected);
  }
}

// A sphere in a sphere, with and without the hollow by turns.
TEST(DynamicTightCocone, CavitiesAreKeptFromTheNextCallOn) {
  ChangingPoints changing(gallery::even_sphere(1500));
  for (const Point& p : gallery::even_sphere(500)) changing.points.push_back(0.4 * p);
  DynamicTightCocone cocone;
  cocone.reconstruct(changing.points);
  Random random(7);
  for (const bool keep : {true, false, false, true}) {
    cocone.keep_cavities(keep);
    const Point center = random.on_unit_sphere();
    changing.change([&](const Point& p) { return distance(p, center) < 0.1; }, {1.01 * center});
    ReconstructResult expected;
    is_local_and_equal(cocone, changing, expected);
    EXPECT_EQ(mesh_check(expected.mesh).components, keep ? 2U : 1U);
  }
}

}  // namespace
}  // namespace cocoon
