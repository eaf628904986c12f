// A boss is put on a block, or a pocket milled into it, and scanned straight from above: not one
// sample of its walls, only top or floor and the level around.
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "geom/mesh_check.h"
#include "geom/mesh_measure.h"
#include "geom/random/random.h"
#include "tests/update/hand_made_models.h"
#include "tests/update/session_checks.h"
#include "update/update_model.h"
#include "update/update_session.h"

namespace cocoon {
namespace {

constexpr double top = 12;  // of the block, vertices 1 apart
const Point center = {20, 15, top};

struct Scene {
  double height = 6;  // of the boss; below 0: of a pocket
  double radius = 4;
  double noise = 0.05;
};

std::vector<std::vector<Point>> scan(const Scene& scene) {
  Random random(5);
  std::vector<std::vector<Point>> clouds(1);
  for (double x = 7.3; x < 33; ++x) {
    for (double y = 2.4; y < 28; ++y) {
      Point p{x + random.uniform(-0.25, 0.25), y + random.uniform(-0.25, 0.25), top};
      const double r = std::hypot(p.x - center.x, p.y - center.y);
      if (r > scene.radius + 4.5) continue;
      if (r < scene.radius) p.z += scene.height;
      for (double* c : {&p.x, &p.y, &p.z}) *c += random.uniform(-scene.noise, scene.noise);
      clouds[0].push_back(p);
    }
  }
  return clouds;
}

// The volume that the update has added, as a share of what it should be.
double share_of_change(const TriangleMesh& model, const UpdateResult& result, const Scene& scene) {
  const double added = mesh_measure(result.mesh).volume - mesh_measure(model).volume;
  return added / (std::numbers::pi * scene.radius * scene.radius * scene.height);
}

TEST(UpdateFromAbove, ABossStandsOnTheModel) {
  const TriangleMesh model = testing::block(40, 30, 12);
  UpdateOptions blind;
  blind.sight.step = 0;
  double shares = 0;
  double blind_shares = 0;
  for (const double height : {4.0, 6.0, 8.0}) {
    for (const double radius : {3.0, 5.0}) {
      SCOPED_TRACE(::testing::Message() << height << " " << radius);
      const Scene scene{.height = height, .radius = radius};
      const auto clouds = scan(scene);
      const UpdateResult result = update_model(model, clouds);
      ASSERT_EQ(result.status, UpdateStatus::ok) << result.message;
      const MeshReport report = mesh_check(result.mesh);
      EXPECT_EQ(report.components, 1U);
      EXPECT_EQ(report.euler, 2);
      EXPECT_GT(share_of_change(model, result, scene), 0.8);
      shares += share_of_change(model, result, scene);
      blind_shares += share_of_change(model, update_model(model, clouds, blind), scene);
    }
  }
  EXPECT_GT(shares, 5.5);
  EXPECT_LT(blind_shares, shares - 0.5);
}

TEST(UpdateFromAbove, APocketIsOpen) {
  const TriangleMesh model = testing::block(40, 30, 12);
  for (const double depth : {4.0, 6.0, 8.0}) {
    SCOPED_TRACE(depth);
    const Scene scene{.height = -depth, .radius = 5};
    const UpdateResult result = update_model(model, scan(scene));
    ASSERT_EQ(result.status, UpdateStatus::ok) << result.message;
    EXPECT_EQ(mesh_check(result.mesh).euler, 2);
    EXPECT_GT(share_of_change(model, result, scene), 0.75);
  }
}

// What is likely is told in the report.
TEST(UpdateFromAbove, WhatWasSeenIsCounted) {
  const TriangleMesh model = testing::block(40, 30, 12);
  const auto clouds = scan({.height = 8, .radius = 3});
  const ReconstructCounters counters = update_model(model, clouds).reconstruction.counters;
  EXPECT_GT(counters.likely_cells, counters.contradicted_likely);
  EXPECT_GT(counters.contradicted_likely, 0U);
  EXPECT_EQ(counters.heeded_likely, counters.likely_cells);
  UpdateOptions blind;
  blind.sight.step = 0;
  const ReconstructCounters without = update_model(model, clouds, blind).reconstruction.counters;
  EXPECT_EQ(without.likely_cells, 0U);
  EXPECT_EQ(without.heeded_likely, 0U);
}

// Bosses one after the other, and an update of what has just been made.
TEST(UpdateFromAbove, ASessionSeesTheSame) {
  const TriangleMesh model = testing::block(40, 30, 12);
  UpdateSession session(model);
  TriangleMesh before = model;
  for (const Scene& scene :
       {Scene{.height = 8, .radius = 3}, Scene{.height = 4, .radius = 5}, Scene{.height = -6}}) {
    const auto clouds = scan(scene);
    const UpdateResult expected = update_model(before, clouds);
    const SessionUpdate update = session.apply(clouds);
    ASSERT_EQ(update.result.status, expected.status) << expected.message;
    if (expected.status != UpdateStatus::ok) continue;
    EXPECT_EQ(session.model(), expected.mesh);
    before = expected.mesh;
  }
}

}  // namespace
}  // namespace cocoon
