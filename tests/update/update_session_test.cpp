// A session gives what starting over gives, after whatever came before.
#include "update/update_session.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <memory>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

#include "delaunay/delaunay.h"
#include "geom/errors.h"
#include "io/mesh_file.h"
#include "io/sample_models.h"
#include "tests/gallery.h"
#include "tests/long_tests.h"
#include "tests/stop_after.h"
#include "tests/update/session_checks.h"

namespace cocoon {
namespace {

// Random updates and undos; every model that undo brings back is compared with the one from then.
// Returns the number of updates.
std::size_t run_steps(UpdateSession& session, std::size_t count, std::uint64_t seed,
                      double steepness = 0.5) {
  const std::size_t steps = count * test::long_factor();
  std::size_t updates = 0;
  Random random(seed);
  std::vector<TriangleMesh> models;
  for (std::size_t step = 0; step < steps; ++step) {
    SCOPED_TRACE("seed " + std::to_string(seed) + ", step " + std::to_string(step));
    if (session.undo_levels() > 0 && random.below(3) == 0) {
      const TriangleMesh before = session.model();
      const MeshChange change = session.undo({.threads = static_cast<int>(1 + random.below(2))});
      EXPECT_TRUE(session.model() == models.back());
      expect_change(before, session.model(), change);
      models.pop_back();
      continue;
    }
    TriangleMesh before = session.model();
    const bool updated = apply_and_compare(session, random_scans(before, random, steepness),
                                           {.threads = static_cast<int>(1 + random.below(3))});
    if (::testing::Test::HasFailure()) return updates;
    if (!updated) continue;
    ++updates;
    models.push_back(std::move(before));
  }
  return updates;
}

TEST(UpdateSession, StartsWithTheReconstructionOfItsPoints) {
  const std::vector<Point> points = gallery::even_sphere(500);
  const UpdateSession session(points);
  const ReconstructResult expected = reconstruct_tight(points);
  EXPECT_TRUE(session.model() == expected.mesh);
  EXPECT_EQ(session.reconstruction().counters.candidates, expected.counters.candidates);
  EXPECT_EQ(session.undo_levels(), 0U);
}

TEST(UpdateSession, RandomStepsOnASphere) {
  UpdateSession session(gallery::even_sphere(700));
  EXPECT_GT(run_steps(session, 20, 1), 6U);
}

// Single scans with low hills; what is not local is taken back, so that the surface stays certain.
std::size_t run_gentle_steps(UpdateSession& session, int steps) {
  Random random(5);
  std::size_t updates = 0;
  for (int step = 0; step < steps; ++step) {
    SCOPED_TRACE("step " + std::to_string(step));
    const TriangleMesh before = session.model();
    const double edge = mean_edge(before);
    const double reach = edge * (5 + 5 * random.uniform());
    const double height = 0.05 * reach * (2 * random.uniform() - 1);
    const VertexId center(random.below(before.points.size()));
    const std::size_t local = session.local_changes();
    const int threads = static_cast<int>(1 + random.below(3));
    if (!apply_and_compare(session, {scan_of(before, center, reach, height, 0.15 * edge, random)},
                           {.threads = threads})) {
      continue;
    }
    ++updates;
    if (session.local_changes() > local && random.below(3) > 0) continue;
    session.undo();
    EXPECT_TRUE(session.model() == before);
  }
  return updates;
}

// Gentle changes leave the surface certain: nothing but what is near them is looked at, and the
// result is still that of starting over.
TEST(UpdateSession, GentleStepsOnASphereAreLocal) {
  UpdateSession session(gallery::even_sphere(1500));
  EXPECT_GT(run_gentle_steps(session, 25), 20U);
  EXPECT_GT(session.local_changes(), 15U);
}

// With pruned candidates here and there.
TEST(UpdateSession, GentleStepsOnATorusAreLocal) {
  UpdateSession session(gallery::displaced_torus(2500, 1, 0));
  EXPECT_GT(run_gentle_steps(session, 15), 10U);
  EXPECT_GT(session.local_changes(), 7U);
}

// Sharp edges, flat faces, cospherical lattices.
TEST(UpdateSession, RandomStepsOnABox) {
  UpdateSession session(gallery::box_faces(12));
  EXPECT_GT(run_steps(session, 25, 2), 3U);
}

TEST(UpdateSession, RandomStepsOnTheTestBlock) {
  UpdateSession session(sample_model("block", {.points = 1500}).initial);
  EXPECT_GT(run_steps(session, 20, 3), 5U);
}

// A scanned animal, given as a mesh: thin legs, uneven sampling.
TEST(UpdateSession, RandomStepsOnARealMesh) {
  UpdateSession session(read_mesh(std::string(COCOON_TEST_DATA) + "/models/elephant.off"));
  EXPECT_GT(run_steps(session, 12, 4), 3U);
}

// A part of machinery, given as points: creases, flat faces, unused samples.
TEST(UpdateSession, RandomStepsOnCadPoints) {
  const TriangleMesh part = read_mesh(std::string(COCOON_TEST_DATA) + "/models/anchor_dense.off");
  UpdateSession session(part.points.span());
  EXPECT_GT(run_steps(session, 12, 5), 1U);
}

// Its triangles may be in any order, also when it comes back.
TEST(UpdateSession, AMeshThatWasGivenIsNoReconstruction) {
  Random random(8);
  TriangleMesh mesh = reconstruct_tight(gallery::even_sphere(700)).mesh;
  std::reverse(mesh.triangles.begin(), mesh.triangles.end());
  UpdateSession session(mesh);
  for (int step = 0; step < 5; ++step) {
    const double edge = mean_edge(mesh);
    const VertexId center(random.below(mesh.points.size()));
    EXPECT_TRUE(apply_and_compare(
        session, {scan_of(mesh, center, 6 * edge, 0.1 * edge, 0.15 * edge, random)}, {}));
    session.undo();
    EXPECT_TRUE(session.model() == mesh);
  }
}

// The surface of its points is certain, but another mesh than the model.
TEST(UpdateSession, GoesOnFromASnapshotOfAMeshThatCameBack) {
  Random random(8);
  TriangleMesh mesh = reconstruct_tight(gallery::even_sphere(700)).mesh;
  std::reverse(mesh.triangles.begin(), mesh.triangles.end());
  const double edge = mean_edge(mesh);
  const Clouds clouds{scan_of(mesh, VertexId(50), 6 * edge, 0.1 * edge, 0.15 * edge, random)};
  for (const bool is_released : {false, true}) {
    UpdateSession session(mesh);
    ASSERT_EQ(session.apply(clouds).result.status, UpdateStatus::ok);
    session.undo();
    SessionSnapshot snapshot = is_released ? std::move(session).release() : session.snapshot();
    UpdateSession again(std::move(snapshot));
    EXPECT_TRUE(again.model() == mesh);
    EXPECT_TRUE(apply_and_compare(again, clouds));
  }
}

// What is said of a region holds for one update, and gives what an update of the mesh gives.
TEST(UpdateSession, TakesOverridesOfOneUpdate) {
  Random random(9);
  const TriangleMesh mesh = reconstruct_tight(gallery::even_sphere(700)).mesh;
  const double edge = mean_edge(mesh);
  const Clouds clouds{scan_of(mesh, VertexId(50), 6 * edge, 0.1 * edge, 0.15 * edge, random)};
  UpdateSession session(mesh);
  const std::vector<RegionId> usual = session.apply(clouds).result.replaced_groups;
  ASSERT_EQ(usual.size(), 1U);
  session.undo();
  UpdateOptions options;
  options.overrides.kept = usual;
  EXPECT_TRUE(session.apply(clouds, options.overrides).result.replaced_groups.empty());
  EXPECT_TRUE(session.model() == update_model(mesh, clouds, options).mesh);
  session.undo();
  EXPECT_EQ(session.apply(clouds).result.replaced_groups, usual);
}

TEST(UpdateSession, GoesOnFromASnapshot) {
  Random random(6);
  UpdateSession session(gallery::even_sphere(600));
  std::size_t updates = 0;
  for (int step = 0; step < 4; ++step) {
    UpdateSession again(session.snapshot(), session.options());
    ASSERT_TRUE(again.model() == session.model());
    const Clouds clouds = random_scans(session.model(), random);
    const UpdateStatus status = session.apply(clouds).result.status;
    apply_and_compare(again, clouds);
    EXPECT_TRUE(again.model() == session.model());
    if (status == UpdateStatus::ok) {
      ++updates;
      again.undo();
      const SessionSnapshot back = again.snapshot();
      EXPECT_EQ(back.points.size(), back.triangulation.num_vertices());
    }
  }
  EXPECT_GT(updates, 1U);
}

void expect_equal_snapshots(const SessionSnapshot& actual, const SessionSnapshot& expected) {
  EXPECT_TRUE(actual.model == expected.model);
  EXPECT_TRUE(actual.points == expected.points);
  EXPECT_TRUE(actual.point_of_vertex == expected.point_of_vertex);
  EXPECT_TRUE(actual.triangulation.points() == expected.triangulation.points());
  EXPECT_TRUE(actual.triangulation.cell_records() == expected.triangulation.cell_records());
  EXPECT_TRUE(actual.triangulation.vertex_of_point() == expected.triangulation.vertex_of_point());
  EXPECT_EQ(actual.triangulation.num_finite_cells(), expected.triangulation.num_finite_cells());
  EXPECT_TRUE(actual.surface == expected.surface);
}

// What a session gives up is its snapshot: after updates that left gaps among vertices and cells,
// of certain surfaces and others, and before there is a triangulation.
TEST(UpdateSession, GivesUpWhatItsSnapshotShows) {
  const TriangleMesh part = read_mesh(std::string(COCOON_TEST_DATA) + "/models/anchor_dense.off");
  for (const std::vector<Point>& points : {gallery::even_sphere(600), part.points.raw()}) {
    Random random(12);
    UpdateSession session(points);
    for (int step = 0; step < 4; ++step) {
      session.apply(random_scans(session.model(), random, 0.1));
    }
    EXPECT_GT(session.undo_levels(), 0U);
    const SessionSnapshot expected = session.snapshot();
    expect_equal_snapshots(std::move(session).release(), expected);
    EXPECT_TRUE(session.model().triangles.empty());
  }
  UpdateSession untouched(part);
  const SessionSnapshot expected = untouched.snapshot();
  EXPECT_EQ(expected.triangulation.num_cells(), 0U);
  expect_equal_snapshots(std::move(untouched).release(), expected);
}

// Each step in a session made of the snapshot of the one before: what that knew of its surface is
// not looked for again.
std::size_t local_steps_from_snapshots(Points points, int steps) {
  Random random(10);
  auto session = std::make_unique<UpdateSession>(points);
  std::size_t local = 0;
  for (int step = 0; step < steps; ++step) {
    SCOPED_TRACE("step " + std::to_string(step));
    const TriangleMesh& model = session->model();
    const double edge = mean_edge(model);
    const VertexId center(random.below(model.points.size()));
    auto next = std::make_unique<UpdateSession>(session->snapshot(), session->options());
    const Clouds clouds{scan_of(model, center, 6 * edge, 0.2 * edge, 0.15 * edge, random)};
    if (!apply_and_compare(*next, clouds) || next->local_changes() == 0) continue;
    ++local;
    session = std::move(next);
  }
  return local;
}

TEST(UpdateSession, GoesOnFromASnapshotWithoutLookingAtTheWhole) {
  EXPECT_GE(local_steps_from_snapshots(gallery::even_sphere(1200), 8), 6U);
  EXPECT_GE(local_steps_from_snapshots(gallery::displaced_torus(1500, 1, 0), 6), 4U);
}

// Boundary samples, creases, unused samples: there is no certificate, but the candidates are known,
// and the body.
TEST(UpdateSession, GoesOnFromSnapshotsOfUncertainSurfaces) {
  const TriangleMesh part = read_mesh(std::string(COCOON_TEST_DATA) + "/models/anchor_dense.off");
  UpdateSession session(part.points.span());
  Random random(11);
  std::size_t updates = 0;
  for (int step = 0; step < 6; ++step) {
    const SessionSnapshot snapshot = session.snapshot();
    ASSERT_FALSE(snapshot.surface.empty());
    EXPECT_TRUE(snapshot.surface.sides.empty());
    EXPECT_FALSE(snapshot.surface.out.empty());
    UpdateSession again(snapshot, session.options());
    const Clouds clouds = random_scans(session.model(), random, 0.1);
    updates += apply_and_compare(again, clouds) ? 1U : 0U;
    session.apply(clouds);
    EXPECT_TRUE(again.model() == session.model());
  }
  EXPECT_GT(updates, 1U);
}

TEST(UpdateSession, ExtremeCoordinatesWorkToo) {
  const double size = 0x1p+150;
  UpdateSession session(gallery::scaled(gallery::even_sphere(400), size));
  Random random(7);
  std::size_t updates = 0;
  for (int step = 0; step < 5; ++step) {
    updates += apply_and_compare(session, random_scans(session.model(), random)) ? 1 : 0;
  }
  EXPECT_GT(updates, 1U);
  while (session.undo_levels() > 0) session.undo();
  EXPECT_TRUE(session.model() ==
              reconstruct_tight(gallery::scaled(gallery::even_sphere(400), size)).mesh);
}

TEST(UpdateSession, CancelledAnywhereItStaysAsItWas) {
  UpdateSession session(gallery::even_sphere(400));
  Random random(8);
  Clouds clouds = random_scans(session.model(), random);
  while (update_model(session.model(), clouds).status != UpdateStatus::ok) {
    clouds = random_scans(session.model(), random);
  }
  const TriangleMesh before = session.model();
  const ReconstructResult reconstruction_before = session.reconstruction();
  const int cancelled = test::stop_everywhere(
      [&](Progress& progress) {
        session.apply(clouds, {1, &progress});
      },
      [&](int) {
        ASSERT_TRUE(session.model() == before);
        ASSERT_EQ(session.undo_levels(), 0U);
        expect_equal_reconstruction(session.reconstruction(), reconstruction_before);
      },
      3);
  EXPECT_GT(cancelled, 10);
  const TriangleMesh after = session.model();
  const ReconstructResult reconstruction_after = session.reconstruction();
  const int undos_cancelled = test::stop_everywhere(
      [&](Progress& progress) {
        session.undo({1, &progress});
      },
      [&](int) {
        ASSERT_TRUE(session.model() == after);
        expect_equal_reconstruction(session.reconstruction(), reconstruction_after);
      },
      3);
  EXPECT_GT(undos_cancelled, 0);
  EXPECT_EQ(session.undo_levels(), 0U);
  EXPECT_TRUE(session.model() == before);
  expect_equal_reconstruction(session.reconstruction(), reconstruction_before);
  apply_and_compare(session, clouds);
}

// Its labels, known from the model before, are not those of the surface that is found again then.
TEST(UpdateSession, GoesOnAfterAnUpdateThatWasCancelledAtItsEnd) {
  struct StopAtEnd : Progress {
    bool report(std::string_view stage, double fraction) override {
      return stage != "reconstruction" || fraction < 1;
    }
  };
  UpdateSession session(read_mesh(std::string(COCOON_TEST_DATA) + "/models/elephant.off"));
  Random random(1);
  for (int step = 0; step < 2; ++step) {
    StopAtEnd stop;
    EXPECT_THROW(session.apply(random_scans(session.model(), random, 0.1), {1, &stop}), Cancelled);
    EXPECT_TRUE(apply_and_compare(session, random_scans(session.model(), random, 0.1)));
  }
}

TEST(UpdateSession, BadInputLeavesTheModel) {
  UpdateSession session(gallery::even_sphere(400));
  const TriangleMesh before = session.model();
  EXPECT_THROW(session.apply({}), InputError);
  EXPECT_THROW(session.apply(Clouds{{{0, 0, 0}, {1, 0, 0}}}), InputError);
  EXPECT_THROW(session.apply(Clouds{{{0, 0, std::nan("")}}}), InputError);
  EXPECT_NE(session.apply(Clouds{gallery::even_sphere(200)}).result.status, UpdateStatus::ok);
  EXPECT_TRUE(session.model() == before);
  UpdateSession empty{TriangleMesh{}};
  std::vector<Point> cap = gallery::even_sphere(400);
  std::erase_if(cap, [](const Point& p) { return p.z < 0.6; });
  EXPECT_THROW(empty.apply(Clouds{cap}), InputError);
}

TEST(UpdateSession, KeepsTheLastStepsOnly) {
  UpdateSession session(gallery::even_sphere(400));
  Random random(9);
  std::size_t updates = 0;
  for (int step = 0; step < 60 && updates < UpdateSession::max_undo_levels + 2; ++step) {
    const VertexId center(random.below(session.model().points.size()));
    const Clouds clouds{scan_of(session.model(), center, 0.7, 0.1, 0.01, random)};
    updates += session.apply(clouds).result.status == UpdateStatus::ok ? 1 : 0;
  }
  ASSERT_GT(updates, UpdateSession::max_undo_levels);
  EXPECT_EQ(session.undo_levels(), UpdateSession::max_undo_levels);
  while (session.undo_levels() > 0) session.undo();
  apply_and_compare(session, random_scans(session.model(), random));
}

TEST(UpdateSession, RefusesSnapshotsThatDoNotFit) {
  const UpdateSession session(gallery::even_sphere(100));
  const auto error_after = [&](auto change) {
    SessionSnapshot snapshot = session.snapshot();
    change(snapshot);
    EXPECT_THROW(UpdateSession(std::move(snapshot)), InputError);
  };
  error_after([](SessionSnapshot& s) { s.points.pop_back(); });
  error_after([](SessionSnapshot& s) { s.points[3].x += 1; });
  error_after([](SessionSnapshot& s) { s.point_of_vertex[VertexId(2)] = PointId(1000); });
  error_after([](SessionSnapshot& s) { s.model.triangles[TriangleId(0)][1] = VertexId(5000); });
  error_after([](SessionSnapshot& s) {
    s.triangulation = delaunay(gallery::even_sphere(99)).triangulation;
  });
  error_after([](SessionSnapshot& s) { s.triangulation = {}; });
  error_after([](SessionSnapshot& s) { s.model.triangles.raw().pop_back(); });
}

TEST(UpdateSession, RefusesABodyThatTheModelDoesNotBound) {
  const TriangleMesh part = read_mesh(std::string(COCOON_TEST_DATA) + "/models/anchor_dense.off");
  const SessionSnapshot good = UpdateSession(part.points.span()).snapshot();
  EXPECT_NO_THROW(check_snapshot(good));
  SessionSnapshot bad = good;
  const auto in = std::find(bad.surface.out.begin(), bad.surface.out.end(), 0);
  ASSERT_NE(in, bad.surface.out.end());
  *in = 1;
  EXPECT_THROW(check_snapshot(bad), InputError);
  EXPECT_THROW(UpdateSession(std::move(bad)), InputError);
}

TEST(UpdateSession, RefusesSurfacesThatDoNotFit) {
  const UpdateSession session(gallery::even_sphere(200));
  const SessionSnapshot good = session.snapshot();
  EXPECT_NO_THROW(check_snapshot(good));
  ASSERT_FALSE(good.surface.sides.empty());
  const auto error_after = [&](auto change) {
    SessionSnapshot snapshot = good;
    change(snapshot.surface);
    EXPECT_THROW(check_snapshot(snapshot), InputError);
  };
  const auto first_with = [](const IdVector<CellId, std::uint8_t>& flags, unsigned flag) {
    CellId c(0);
    while ((flags[c] & flag) == 0) c = CellId(c.index() + 1);
    return c;
  };
  const CellId hull = first_with(good.surface.candidates.cell_flags, cell_flag::infinite);
  const CellId outer = first_with(good.surface.sides, 15);
  error_after([](SurfaceState& s) { s.sides.raw().pop_back(); });
  error_after([](SurfaceState& s) { s.candidates.normals.raw().pop_back(); });
  error_after([](SurfaceState& s) { s.candidates.normals[VertexId(3)].z = 1.0 / 0.0; });
  error_after([](SurfaceState& s) { s.candidates.vertex_flags[VertexId(3)] = 8; });
  error_after([](SurfaceState& s) { s.candidates.samples[VertexId(3)] = SampleState(3); });
  error_after([&](SurfaceState& s) { s.candidates.cell_flags[hull] |= 1; });
  error_after([&](SurfaceState& s) { s.candidates.cell_flags[hull] ^= cell_flag::finite; });
  error_after([&](SurfaceState& s) { s.candidates.cell_flags[outer] &= 0xF0; });
  error_after([&](SurfaceState& s) { s.candidates.pruned[outer] = s.sides[outer] & 15U; });
  error_after([&](SurfaceState& s) { s.sides[outer] = 0; });
  error_after([](SurfaceState& s) { s.sheets.raw().pop_back(); });
  error_after([](SurfaceState& s) { s.sheets[VertexId(3)] = SheetAt(3); });
  error_after([](SurfaceState& s) { s.sheets[VertexId(3)] = SheetAt::none; });
  error_after(
      [&](SurfaceState& s) { s.sides[outer] = static_cast<std::uint8_t>(s.sides[outer] << 4); });
}

TEST(UpdateSession, NothingToTakeBackIsACallersMistake) {
  UpdateSession session(gallery::even_sphere(300));
  EXPECT_THROW(session.undo(), InputError);
  EXPECT_EQ(session.model().triangles.size(), 2U * 300 - 4);
}

TEST(UpdateSession, KeepsNoMoreUndosThanItIsTold) {
  UpdateSession session(gallery::even_sphere(700));
  Random random(4);
  std::size_t updates = 0;
  const auto update = [&] {
    for (int tries = 0; tries < 20; ++tries) {
      if (session.apply(random_scans(session.model(), random, 0.1)).result.status !=
          UpdateStatus::ok) {
        continue;
      }
      ++updates;
      return;
    }
  };
  for (int k = 0; k < 3; ++k) update();
  ASSERT_EQ(updates, 3U);
  EXPECT_EQ(session.undo_levels(), 3U);
  session.limit_undo(2);
  EXPECT_EQ(session.undo_levels(), 2U);
  session.limit_undo(0);
  EXPECT_EQ(session.undo_levels(), 0U);
  update();
  EXPECT_EQ(session.undo_levels(), 0U);
  EXPECT_THROW(session.undo(), InputError);
  session.limit_undo(UpdateSession::max_undo_levels + 5);
  update();
  EXPECT_EQ(session.undo_levels(), 1U);
}

}  // namespace
}  // namespace cocoon
