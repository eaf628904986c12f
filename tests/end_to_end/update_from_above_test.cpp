// A boss is put on a block, or a pocket milled into it, and scanned straight from above: not one
// sample of its walls, only top or floor and the level around.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <vector>

#include "cocone/reconstruct.h"
#include "geom/mesh_check.h"
#include "geom/mesh_measure.h"
#include "geom/random/random.h"
#include "tests/mesh_gallery.h"
#include "tests/update/hand_made_models.h"
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
  double shift = 0;  // along x
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
      p.x += scene.shift;
      clouds[0].push_back(p);
    }
  }
  return clouds;
}

// The volume that the update has added, as a share of what it should be.
double share_of_change(const TriangleMesh& model, const UpdateResult& result, const Scene& scene) {
  const double added = mesh_measure(result.mesh).signed_volume - mesh_measure(model).signed_volume;
  return added / (std::numbers::pi * scene.radius * scene.radius * scene.height);
}

// A block, made of samples that are stirred within its faces.
TriangleMesh sampled_block() {
  Random random(3);
  std::vector<Point> points = testing::block(40, 30, 12).points.raw();
  const auto stir = [&](double& x, double end) {
    if (x > 0 && x < end) x += random.uniform(-0.3, 0.3);
  };
  for (Point& p : points) {
    stir(p.x, 40);
    stir(p.y, 30);
    stir(p.z, 12);
  }
  return reconstruct_tight(points).mesh;
}

struct Shares {
  double sum = 0;
  double least = 10;
  double most = 0;
};

// Of updates by each of these scans, all closed and in one piece without a handle.
Shares shares_of(const TriangleMesh& model, const std::vector<Scene>& scenes,
                 const UpdateOptions& options = {}) {
  Shares shares;
  for (const Scene& scene : scenes) {
    SCOPED_TRACE(::testing::Message() << scene.height << ' ' << scene.radius << ' ' << scene.noise);
    const UpdateResult result = update_model(model, scan(scene), options);
    EXPECT_EQ(result.status, UpdateStatus::ok) << result.message;
    const MeshReport report = mesh_check(result.mesh);
    EXPECT_EQ(report.components, 1U);
    EXPECT_EQ(report.euler, 2);
    const double share = share_of_change(model, result, scene);
    shares.sum += share;
    shares.least = std::min(shares.least, share);
    shares.most = std::max(shares.most, share);
  }
  return shares;
}

// By the first look alone, too: the second makes good some of that.
UpdateOptions blind() {
  UpdateOptions options;
  options.sight.step = 0;
  options.reconstruct.second_look.enabled = false;
  return options;
}

TEST(UpdateFromAbove, ABossStandsOnTheModel) {
  const TriangleMesh model = sampled_block();
  std::vector<Scene> scenes;
  for (const double height : {4.0, 6.0, 8.0}) {
    for (const double radius : {3.0, 5.0}) scenes.push_back({height, radius});
  }
  const Shares shares = shares_of(model, scenes);
  EXPECT_GT(shares.least, 0.75);
  EXPECT_GT(shares.sum, 5.4);
  double blind_sum = 0;
  for (const Scene& scene : scenes) {  // which may float
    blind_sum += share_of_change(model, update_model(model, scan(scene), blind()), scene);
  }
  EXPECT_LT(blind_sum, shares.sum - 0.5);
}

// Also in a foreign mesh.
TEST(UpdateFromAbove, APocketIsOpen) {
  const std::vector<Scene> scenes = {{-4, 5}, {-6, 5}, {-8, 5}};
  for (const TriangleMesh& model : {testing::block(40, 30, 12), sampled_block()}) {
    const Shares shares = shares_of(model, scenes);
    EXPECT_GT(shares.least, 0.8);
    EXPECT_LT(shares_of(model, scenes, blind()).sum, shares.sum - 0.15);
  }
}

// Samples agree about a surface across its mouth, and nothing is in doubt but the floor behind it.
TEST(UpdateFromAbove, APocketDeeperThanItIsWideIsOpen) {
  const std::vector<Scene> scenes = {{-8, 3, 0}, {-8, 3, 0.05}, {-8, 4, 0}, {-8, 4, 0.05}};
  for (const TriangleMesh& model : {testing::block(40, 30, 12), sampled_block()}) {
    const Shares shares = shares_of(model, scenes);
    EXPECT_GT(shares.least, 0.6);
    EXPECT_LT(shares.most, 1.25);
  }
}

// No mark reaches the wall of a hollow elsewhere in the block, and no sample saw it: it stays.
TEST(UpdateFromAbove, AHollowBesideAPocketStays) {
  const TriangleMesh block = sampled_block();
  const std::size_t outer = block.points.size();
  const TriangleMesh cavity = gallery::translated(testing::block(6, 10, 4), {2, 10, 4});
  const TriangleMesh model = gallery::join(block, gallery::flipped(cavity));
  const Scene scene{-8, 3, 0.05, 6};
  const UpdateResult result = update_model(model, scan(scene));
  ASSERT_EQ(result.status, UpdateStatus::ok) << result.message;
  EXPECT_GT(result.reconstruction.counters.heeded_likely, 0U);
  EXPECT_EQ(mesh_check(result.mesh).components, 2U);
  EXPECT_EQ(mesh_check(result.mesh).euler, 4);
  EXPECT_NEAR(share_of_change(model, result, scene), 1, 0.3);
  for (std::size_t v = outer; v < model.points.size(); ++v) {
    EXPECT_FALSE(result.vertex_map[VertexId(v)].is_none()) << v;
  }
}

// Its floor is closer to the far side of the model than to the side that was scanned.
TEST(UpdateFromAbove, APocketDownToAThinFloorIsOpen) {
  const std::vector<Scene> scenes = {{-10, 4}, {-10, 5}, {-10, 8}};
  const Shares shares = shares_of(sampled_block(), scenes);
  EXPECT_GT(shares.least, 0.6);
  EXPECT_LT(shares.most, 1.25);
}

TEST(UpdateFromAbove, WhatWasSeenIsCounted) {
  const TriangleMesh model = sampled_block();
  const auto clouds = scan({.height = 8, .radius = 3});
  const ReconstructCounters counters = update_model(model, clouds).reconstruction.counters;
  EXPECT_GE(counters.likely_cells, counters.contradicted_likely);
  EXPECT_GT(counters.contradicted_likely, 0U);
  EXPECT_EQ(counters.heeded_likely, counters.likely_cells);
  const ReconstructCounters without = update_model(model, clouds, blind()).reconstruction.counters;
  EXPECT_EQ(without.likely_cells, 0U);
  EXPECT_EQ(without.heeded_likely, 0U);
}

// One scan of both: what helps one of them must not be refused for what the other lacks.
TEST(UpdateFromAbove, TwoChangesInOneScan) {
  const TriangleMesh model = sampled_block();
  for (const double height : {4.0, 6.0, 8.0, -4.0, -6.0, -8.0}) {
    SCOPED_TRACE(height);
    const Scene deep{height, 4, 0.05, -10};
    const Scene flat{height / 2, 4, 0.05, 10};
    std::vector<std::vector<Point>> clouds = scan(deep);
    const std::vector<Point> other = scan(flat)[0];
    clouds[0].insert(clouds[0].end(), other.begin(), other.end());
    const UpdateResult result = update_model(model, clouds);
    ASSERT_EQ(result.status, UpdateStatus::ok) << result.message;
    EXPECT_EQ(mesh_check(result.mesh).components, 1U);
    EXPECT_EQ(mesh_check(result.mesh).euler, 2);
    EXPECT_NEAR(share_of_change(model, result, {1.5 * height, 4}), 1, 0.2);
  }
}

// Two bosses, or two pockets, one after the other: from the second on the session tells what is
// known by what it has kept. (A second look finds the first boss without.)
TEST(UpdateFromAbove, ASessionSeesTheSame) {
  std::size_t heeded = 0;
  for (const double height : {8.0, -8.0}) {
    UpdateSession session(sampled_block());
    for (const double shift : {-10.0, 10.0}) {
      SCOPED_TRACE(::testing::Message() << height << ' ' << shift);
      const auto clouds = scan({.height = height, .radius = 3, .shift = shift});
      const UpdateResult expected = update_model(session.model(), clouds);
      const SessionUpdate update = session.apply(clouds);
      ASSERT_EQ(update.result.status, UpdateStatus::ok) << expected.message;
      EXPECT_EQ(session.model(), expected.mesh);
      const ReconstructCounters& theirs = expected.reconstruction.counters;
      const ReconstructCounters& ours = update.result.reconstruction.counters;
      EXPECT_EQ(ours.likely_cells, theirs.likely_cells);
      EXPECT_EQ(ours.contradicted_likely, theirs.contradicted_likely);
      EXPECT_EQ(ours.heeded_likely, theirs.heeded_likely);
      EXPECT_GT(ours.likely_cells, 0U);
      heeded += ours.heeded_likely > 0 ? 1U : 0U;
    }
  }
  EXPECT_GE(heeded, 3U);
}

}  // namespace
}  // namespace cocoon
