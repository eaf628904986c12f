#include "update/located_rims.h"

#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <utility>
#include <vector>

#include "geom/errors.h"
#include "tests/update/hand_made_models.h"
#include "tests/update/torn_rims.h"
#include "update/update_model.h"

namespace cocoon {
namespace {

using testing::circle;
using testing::grid_plane;
using testing::inside_out;
using testing::middle;
using testing::radius;
using testing::rim_of;
using testing::torn_rim;

CloudSurface surface_with(CloudRim rim, double rho) {
  CloudSurface surface;
  surface.rim = std::move(rim);
  surface.search.rho = rho;
  return surface;
}

CloudRim small_rim() {
  CloudRim rim = rim_of({circle(15, middle, 1.5)});
  rim.median_edge = rim.spacing;
  rim.rim_edges = rim.loops[0].size();
  return rim;
}

// A disk on the plane, and two trials of its surface: that with rho 1 looked better.
class TwoTrials {
 public:
  TwoTrials(CloudRim first, CloudRim second)
      : mesh_(grid_plane(30)), model_(mesh_), others_{{surface_with(std::move(second), 2)}} {
    reports.push_back(report_of_surface(surface_with(std::move(first), 1)));
    for (double x = -radius; x <= radius; x += 0.5) {
      for (double y = -radius; y <= radius; y += 0.5) {
        if (std::hypot(x, y) <= radius) clouds_[0].push_back(middle + Vec3{x, y, 0});
      }
    }
  }
  // The rho of the one that is taken.
  double taken(const UpdateOptions& options = {}) {
    rims = locate_rims(model_, clouds_, others_, options, reports);
    return reports[0].surface.search.rho;
  }
  LocatedRims rims;
  std::vector<CloudReport> reports;

 private:
  TriangleMesh mesh_;
  ModelIndex model_;
  std::vector<std::vector<Point>> clouds_ = std::vector<std::vector<Point>>(1);
  std::vector<std::vector<CloudSurface>> others_;
};

TEST(LocatedRims, AFarClearerRimIsTaken) {
  TwoTrials trials(torn_rim(20, 40), torn_rim(0, 0));
  EXPECT_EQ(trials.taken(), 2);
  EXPECT_EQ(trials.reports[0].compared_rims, 2U);
  EXPECT_EQ(trials.reports[0].taken_rim, 1U);
  // And it is that one that is located and reported.
  ASSERT_EQ(trials.rims.overlaps.size(), 1U);
  EXPECT_EQ(trials.rims.overlaps[0].status, OverlapStatus::ok);
  EXPECT_EQ(trials.rims.overlaps[0].loops[0].inner_points, 0U);
  EXPECT_EQ(trials.reports[0].boundary_points, 60U);
}

TEST(LocatedRims, OneThatIsHardlyClearerIsNot) {
  TwoTrials trials(torn_rim(20, 40), torn_rim(20, 38));
  EXPECT_EQ(trials.taken(), 1);
  EXPECT_EQ(trials.reports[0].compared_rims, 2U);
  EXPECT_EQ(trials.reports[0].taken_rim, 0U);
  EXPECT_GT(trials.rims.overlaps[0].loops[0].inner_points, 0U);
  UpdateOptions any;
  any.cut.clearer_rim = 1;
  EXPECT_EQ(TwoTrials(torn_rim(20, 40), torn_rim(20, 38)).taken(any), 2);
}

TEST(LocatedRims, OneThatTellsLittleIsNot) {
  EXPECT_EQ(TwoTrials(torn_rim(20, 40), small_rim()).taken(), 1);
  UpdateOptions any;
  any.cut.min_told = 0.1;
  EXPECT_EQ(TwoTrials(torn_rim(20, 40), small_rim()).taken(any), 2);
}

// By it all of the plane but the disk would go.
TEST(LocatedRims, OneByWhichMoreGoesThanWasScannedIsNot) {
  const CloudRim whole = inside_out(torn_rim(0, 0));
  EXPECT_EQ(TwoTrials(torn_rim(20, 40), whole).taken(), 1);
  EXPECT_EQ(TwoTrials(inside_out(torn_rim(20, 40)), whole).taken(), 2);  // as by the other one
  UpdateOptions any;
  any.cut.box_reach = std::numeric_limits<double>::infinity();
  EXPECT_EQ(TwoTrials(torn_rim(20, 40), whole).taken(any), 2);
}

TEST(LocatedRims, WhereNothingIsInDoubtNoneIsComparedNorIfItIsSwitchedOff) {
  TwoTrials whole(torn_rim(0, 0), torn_rim(20, 40));
  EXPECT_EQ(whole.taken(), 1);
  EXPECT_EQ(whole.reports[0].compared_rims, 0U);
  UpdateOptions off;
  off.cut.clearer_rim = 0;
  EXPECT_EQ(TwoTrials(torn_rim(20, 40), torn_rim(0, 0)).taken(off), 1);
}

TEST(LocatedRims, ARimOnTheModelComesBeforeOneThatIsNot) {
  CloudRim off = torn_rim(0, 0);
  for (Point& p : off.loops[0].points) p.z += 100;
  TwoTrials trials(off, torn_rim(20, 40));
  EXPECT_EQ(trials.taken(), 2);
  EXPECT_EQ(trials.rims.overlaps[0].status, OverlapStatus::ok);
  TwoTrials neither(off, off);
  EXPECT_EQ(neither.taken(), 1);
  EXPECT_EQ(neither.rims.overlaps[0].status, OverlapStatus::no_overlap);
}

// A third of it climbs what has changed. It is taken only if no other rim lies on the model.
TEST(LocatedRims, ARimInAShadowIsTakenWhereThereIsNoOther) {
  CloudRim climbing = torn_rim(0, 0);
  for (std::size_t i = 0; i < 20; ++i) climbing.loops[0].points[i].z += 10;
  CloudRim off = torn_rim(0, 0);
  for (Point& p : off.loops[0].points) p.z += 100;
  TwoTrials alone(climbing, off);
  EXPECT_EQ(alone.taken(), 1);
  EXPECT_EQ(alone.rims.overlaps[0].status, OverlapStatus::ok);
  EXPECT_EQ(alone.rims.overlaps[0].figures.in_shadow, 20U);
  EXPECT_EQ(alone.rims.overlaps[0].figures.in_shadow_of, 60U);
  TwoTrials second(off, climbing);
  EXPECT_EQ(second.taken(), 2);
  EXPECT_TRUE(second.rims.overlaps[0].leaves_model);
  TwoTrials other(climbing, torn_rim(20, 40));
  EXPECT_EQ(other.taken(), 2);
  EXPECT_FALSE(other.rims.overlaps[0].figures.in_shadow);
  UpdateOptions none;
  none.shadow.max_unmatched_share = 0;
  EXPECT_EQ(TwoTrials(climbing, off).taken(none), 1);
}

// A second cloud lies on the first one, five above the model: without that it would be off it.
TEST(LocatedRims, WhatOtherCloudsCoverIsAsBeforeWhereNoOtherRimIsTaken) {
  const TriangleMesh mesh = grid_plane(30);
  const ModelIndex model(mesh);
  std::vector<std::vector<Point>> clouds(2);
  for (double x = -3; x <= 3; x += 0.5) {
    for (double y = -3; y <= 3; y += 0.5) {
      clouds[0].push_back(middle + Vec3{x, y, 5});
      if (std::hypot(x, y) <= 1.5) clouds[1].push_back(middle + Vec3{x, y, 5.1});
    }
  }
  CloudRim on_first = small_rim();
  for (Point& p : on_first.loops[0].points) p.z += 5;
  for (Point& p : on_first.loops[0].apexes) p.z += 5;
  CloudRim off = torn_rim(0, 0);
  for (Point& p : off.loops[0].points) p.z += 100;
  std::vector<CloudReport> reports = {report_of_surface(surface_with(torn_rim(20, 40), 1)),
                                      report_of_surface(surface_with(on_first, 1))};
  const std::vector<std::vector<CloudSurface>> others = {{surface_with(off, 2)}, {}};
  const LocatedRims rims = locate_rims(model, clouds, others, {}, reports);
  EXPECT_EQ(reports[0].compared_rims, 2U);
  EXPECT_EQ(reports[0].taken_rim, 0U);
  EXPECT_EQ(rims.overlaps[1].status, OverlapStatus::ok);
  EXPECT_EQ(rims.overlaps[1].loops[0].match, LoopMatch::covered);
}

TEST(LocatedRims, RefusesListsThatDoNotFit) {
  const TriangleMesh mesh = grid_plane(30);
  const ModelIndex model(mesh);
  const std::vector<std::vector<Point>> clouds(2);
  std::vector<CloudReport> reports(2);
  EXPECT_THROW(locate_rims(model, clouds, {}, {}, reports), InputError);
  const std::vector<std::vector<CloudSurface>> others(2);
  reports.pop_back();
  EXPECT_THROW(locate_rims(model, clouds, others, {}, reports), InputError);
}

// Two disks side by side, each with a trial of more and a trial of less doubt. Whether they share
// edges depends on the trials that are taken, and must not on which cloud is the first.
TEST(LocatedRims, DoNotDependOnTheOrderOfClouds) {
  const TriangleMesh mesh = grid_plane(60);
  const ModelIndex model(mesh);
  const Vec3 move{13.6, 0, 0};
  const auto moved = [&](CloudRim rim) {
    for (RimLoop& loop : rim.loops) {
      for (Point& p : loop.points) p = p + move;
      for (Point& p : loop.apexes) p = p + move;
    }
    return rim;
  };
  std::vector<std::vector<Point>> disks(2);
  for (double x = -6; x <= 6; x += 0.6) {
    for (double y = -6; y <= 6; y += 0.6) {
      if (std::hypot(x, y) > 6) continue;
      disks[0].push_back(middle + Vec3{x, y, 0});
      disks[1].push_back(middle + move + Vec3{x, y, 0});
    }
  }
  CloudRim few_samples = torn_rim(0, 0);
  few_samples.median_edge *= 1.8;
  const std::vector<CloudRim> first = {torn_rim(20, 40), moved(torn_rim(20, 40))};
  const std::vector<CloudRim> second = {few_samples, moved(torn_rim(0, 0))};
  // Of each disk, in both orders: shared edges, and which trial was taken.
  std::vector<std::array<std::size_t, 4>> found;
  for (const std::vector<std::size_t>& order :
       {std::vector<std::size_t>{0, 1}, std::vector<std::size_t>{1, 0}}) {
    std::vector<std::vector<Point>> clouds;
    std::vector<CloudReport> reports;
    std::vector<std::vector<CloudSurface>> others;
    for (const std::size_t c : order) {
      clouds.push_back(disks[c]);
      reports.push_back(report_of_surface(surface_with(first[c], 1)));
      others.push_back({surface_with(second[c], 2)});
    }
    locate_rims(model, clouds, others, {}, reports);
    const CloudReport& of_0 = reports[order[0] == 0 ? 0 : 1];
    const CloudReport& of_1 = reports[order[0] == 0 ? 1 : 0];
    found.push_back({of_0.surface.rim.shared_edges, of_1.surface.rim.shared_edges, of_0.taken_rim,
                     of_1.taken_rim});
  }
  EXPECT_EQ(found[0], found[1]);
  EXPECT_EQ(found[0][2] + found[0][3], 2U);
}

}  // namespace
}  // namespace cocoon
