#include "update/checks/unscanned_losses.h"

#include <cmath>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "cocone/reconstruct.h"
#include "geom/errors.h"
#include "geom/mesh_check.h"
#include "io/sample_models.h"
#include "tests/mesh_gallery.h"
#include "tests/update/ball_with_handle.h"
#include "tests/update/hand_made_models.h"
#include "tests/update/session_checks.h"
#include "update/update_model.h"

namespace cocoon {
namespace {

bool warns(const UpdateResult& result) {
  for (const std::string& warning : result.warnings) {
    if (warning.find("though nothing was scanned") != std::string::npos) return true;
  }
  return false;
}

UnscannedLosses losses_among(const ModelIndex& model, std::span<const VertexId> lost,
                             std::span<const Scan> scans, bool lost_handles,
                             const UnscannedOptions& options = {}) {
  std::vector<NearestPointTree> trees;
  for (const Scan& scan : scans) trees.emplace_back(scan.samples);
  return unscanned_losses(model, lost, scans, trees, lost_handles, options);
}

// A plane of 20 x 20 unit squares, of which the vertices from x = 3 on went. Up to x = 5 it was
// scanned, two units apart as far as the scan knows.
struct TornPlane {
  TriangleMesh model = testing::grid_plane(20);
  ModelIndex index{model};
  std::vector<VertexId> lost;
  std::vector<Point> samples;

  TornPlane() {
    for (const VertexId v : model.points.ids()) {
      const Point& p = model.points[v];
      if (p.x > 2.5) lost.push_back(v);
      if (p.x < 5.5) samples.push_back(p);
    }
  }
  UnscannedLosses losses(bool lost_handles = false, const UnscannedOptions& options = {},
                         const Vec3& shift = {}) const {
    const Scan scan{samples, 2, shift};
    return losses_among(index, lost, {&scan, 1}, lost_handles, options);
  }
};

TEST(UnscannedLosses, ThoseFarFromAllSamples) {
  const TornPlane scene;
  const UnscannedLosses found = scene.losses();
  EXPECT_EQ(found.far, 9 * 21U);  // from x = 12
  EXPECT_EQ(found.vertices, found.far);
  EXPECT_EQ(found.farthest, VertexId(20U));
  EXPECT_EQ(found.distance, 7.5);
  EXPECT_EQ(scene.losses(false, {.reach = 5}).far, 5 * 21U);
  EXPECT_EQ(scene.losses(false, {.reach = 7.5}).far, 0U);
  EXPECT_EQ(losses_among(scene.index, {}, {}, true).far, 0U);
}

TEST(UnscannedLosses, EveryScanNeedsATree) {
  const TornPlane scene;
  const Scan scan{scene.samples, 2};
  EXPECT_THROW(unscanned_losses(scene.index, scene.lost, {&scan, 1}, {}, false), InputError);
}

// Where the model is coarser than the scan its edges are what counts.
TEST(UnscannedLosses, InSpacingsOfTheModelIfItIsCoarser) {
  const TornPlane scene;
  const Scan scan{scene.samples, 0.01};
  const double edge = (4 + 2 * std::sqrt(2.0)) / 6;  // at an inner vertex
  const UnscannedLosses found = losses_among(scene.index, scene.lost, {&scan, 1}, false);
  EXPECT_GT(found.far, 12 * 19U);  // from x = 9, at 4
  EXPECT_NEAR(found.distance, 15 / edge, 3);
  // Another scan saw the rest.
  const Scan other{scene.model.points.raw(), 0.01};
  const Scan both[] = {scan, other};
  EXPECT_EQ(losses_among(scene.index, scene.lost, both, false).far, 0U);
}

// Samples off the model near where the loss begins show that something was taken off.
TEST(UnscannedLosses, AChangeExplainsThem) {
  TornPlane scene;
  for (Point& p : scene.samples) {
    if (p.x == 4) p.z = 1.1;
  }
  EXPECT_EQ(scene.losses().far, 9 * 21U);
  EXPECT_EQ(scene.losses().vertices, 0U);
  EXPECT_EQ(scene.losses(true).vertices, 0U);
  // Not that more than a part of the model goes, here 189 of 441 vertices.
  EXPECT_EQ(scene.losses(false, {.max_explained_share = 0.42}).vertices, 9 * 21U);
  EXPECT_EQ(scene.losses(false, {.off_model = 0.6}).vertices, 9 * 21U);
  EXPECT_EQ(scene.losses(false, {.change_reach = 3.5}).vertices, 9 * 21U);
  // Only at a few of the places.
  for (Point& p : scene.samples) {
    if (p.y > 2) p.z = 0;
  }
  EXPECT_EQ(scene.losses().vertices, 9 * 21U);
  EXPECT_EQ(scene.losses(false, {.explained = 0.1}).vertices, 0U);
}

// A strip between two places that were scanned: at one end samples lie off the model.
TEST(UnscannedLosses, AHandleIsExplainedAtBothEndsOrNot) {
  const TriangleMesh model = testing::grid_plane(40);
  const ModelIndex index(model);
  std::vector<VertexId> lost;
  std::vector<Point> samples;
  for (const VertexId v : model.points.ids()) {
    const Point& p = model.points[v];
    if (p.x > 2.5 && p.x < 37.5) lost.push_back(v);
    if (p.x < 5.5 || p.x > 34.5) samples.push_back(p);
    if (p.x == 4) samples.back().z = 1.1;
  }
  const Scan scan{samples, 2};
  EXPECT_EQ(losses_among(index, lost, {&scan, 1}, false).far, 17 * 41U);
  EXPECT_EQ(losses_among(index, lost, {&scan, 1}, false).vertices, 0U);
  EXPECT_EQ(losses_among(index, lost, {&scan, 1}, true).vertices, 17 * 41U);
  for (Point& p : samples) {
    if (p.x == 36) p.z = 1.1;
  }
  EXPECT_EQ(losses_among(index, lost, {&scan, 1}, true).vertices, 0U);
  // What stays in the midst of it was not scanned, either.
  std::erase_if(lost, [&](VertexId v) { return model.points[v] == Point{20, 20, 0}; });
  EXPECT_EQ(losses_among(index, lost, {&scan, 1}, false).vertices, 0U);
  EXPECT_EQ(losses_among(index, lost, {&scan, 1}, true).vertices, 17 * 41U - 1);
}

// A scan out of register seems to lie off the model everywhere; that is no change.
TEST(UnscannedLosses, AShiftExplainsNone) {
  TornPlane scene;
  for (Point& p : scene.samples) p.z = 1.1;
  EXPECT_EQ(scene.losses().vertices, 0U);
  EXPECT_EQ(scene.losses(false, {}, {0, 0, 1.1}).vertices, 10 * 21U);
}

// A part of the model that went as a whole begins nowhere.
TEST(UnscannedLosses, NothingExplainsThatAPartGoes) {
  const TriangleMesh model =
      gallery::join(testing::grid_plane(4), gallery::translated(testing::grid_plane(2), {0, 0, 9}));
  const ModelIndex index(model);
  std::vector<VertexId> lost;
  for (std::uint32_t v = 25; v < 34; ++v) lost.push_back(VertexId(v));
  const std::vector<Point> samples = {{1, 1, 1}, {2, 2, 1}};
  const Scan scan{samples, 1};
  const UnscannedLosses found = losses_among(index, lost, {&scan, 1}, false);
  EXPECT_EQ(found.far, 9U);
  EXPECT_EQ(found.vertices, 9U);
}

TEST(UnscannedLosses, AreLookedForAmongUsedVertices) {
  TriangleMesh model = testing::grid_plane(2);
  model.points.push_back({5, 5, 5});
  const ModelIndex index(model);
  Replacement replacement;
  replacement.vertices.removed = {VertexId(1U), VertexId(9U)};
  IdVector<VertexId, VertexId> map;
  for (const VertexId v : model.points.ids()) map.push_back(v);
  map[VertexId(1U)] = map[VertexId(4U)] = map[VertexId(9U)] = VertexId();
  EXPECT_EQ(lost_vertices(index, replacement, map, true), std::vector<VertexId>{VertexId(1U)});
  const std::vector<VertexId> expected = {VertexId(1U), VertexId(4U)};
  EXPECT_EQ(lost_vertices(index, replacement, map, false), expected);
}

// What goes with the knob of a joystick is far from its scan, as it should be.
TEST(UnscannedLosses, WhatADesignTookAwayIsNoWarning) {
  for (const char* name : {"block", "joystick-1"}) {
    const SampleModel sample = sample_model(name, {.points = 6000, .cloud_points = 1500});
    const TriangleMesh model = reconstruct_tight(sample.initial).mesh;
    const UpdateResult result = update_model(model, sample.clouds);
    ASSERT_EQ(result.status, UpdateStatus::ok) << result.message;
    EXPECT_EQ(result.unscanned.vertices, 0U) << name;
    EXPECT_FALSE(warns(result)) << name;
    EXPECT_EQ(result.euler, mesh_check(result.mesh).euler);
    EXPECT_EQ(result.euler_before, mesh_check(model).euler);
    if (name == std::string("joystick-1")) {
      EXPECT_GT(result.unscanned.far, 10U);
    }
  }
}

// By a session, whose surface is known when it comes, and from scratch. Both feet were scanned, and
// the handle is not there.
TEST(UnscannedLosses, AHandleThatWasTakenOffIsNoWarning) {
  UpdateSession session(testing::ball_with_handle());
  const TriangleMesh model = session.model();
  ASSERT_EQ(mesh_check(model).euler, 0);
  ASSERT_TRUE(apply_and_compare(session, {testing::top_of_ball(7)}));
  session.undo();
  const UpdateResult result = session.apply(Clouds{testing::top_of_ball(7)}).result;
  EXPECT_FALSE(warns(result));
  EXPECT_EQ(result.euler_before, 0);
  EXPECT_EQ(result.euler, 2);
  EXPECT_GT(result.unscanned.far, 100U);
  EXPECT_EQ(result.unscanned.vertices, 0U);
  // Again without the handle: nothing is far.
  const UpdateResult again = session.apply(Clouds{testing::top_of_ball(8)}).result;
  EXPECT_FALSE(warns(again));
  EXPECT_EQ(again.unscanned.far, 0U);
  EXPECT_EQ(again.euler_before, 2);
}

// Of the feet only one was scanned.
TEST(UnscannedLosses, AHandleThatGoesWithOneFootIsAWarning) {
  const TriangleMesh model = reconstruct_tight(testing::ball_with_handle()).mesh;
  std::vector<Point> cloud = testing::top_of_ball(7);
  std::erase_if(cloud, [](const Point& p) { return p.x < 0.1; });
  const UpdateResult result = update_model(model, Clouds{cloud});
  ASSERT_EQ(result.status, UpdateStatus::ok) << result.message;
  EXPECT_TRUE(warns(result));
  EXPECT_EQ(result.euler_before, 0);
  EXPECT_EQ(result.euler, 2);
  ASSERT_GT(result.unscanned.vertices, 50U);
  EXPECT_EQ(result.unscanned.vertices, result.unscanned.far);
  EXPECT_GT(model.points[result.unscanned.farthest].z, 1.1);
}

}  // namespace
}  // namespace cocoon
