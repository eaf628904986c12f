// What samples have to say in the cut: where scans end, and what is gone.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <span>
#include <vector>

#include "tests/update/hand_made_models.h"
#include "tests/update/torn_rims.h"
#include "update/cut_regions.h"

namespace cocoon {
namespace {

using testing::grid_plane;
using testing::middle;
using testing::radius;
using testing::rim_of;
using testing::RimOnAMesh;
using testing::torn_rim;

// Of a belt around a ball one rim is known. Nothing keeps the other half of the ball from lying
// under it, too, but the samples of the belt, which end on it.
TEST(CutRegions, SamplesTellWhereARimIsMissing) {
  const Vec3 south = {0, 0, -1};
  CloudRim rim = rim_of({testing::cap_rim(100, south, std::numbers::pi - 1)});
  rim.median_edge = rim.spacing;
  RimOnAMesh ball(testing::sphere(5), rim);
  std::vector<Point> belt;
  for (double polar = 1; polar < 2.1; polar += 0.05) {
    const double raised = 1 + std::max(0.0, 0.3 - std::abs(polar - 1.5));
    for (int k = 0; k < 120; ++k) {
      const double angle = 2 * std::numbers::pi * k / 120;
      belt.push_back(raised * Point{std::sin(polar) * std::cos(angle),
                                    std::sin(polar) * std::sin(angle), std::cos(polar)});
    }
  }
  ball.scans = {{belt, 0.05}};
  const RegionCut cut = ball.cut();
  EXPECT_GT(cut.scan_ends, 50U);
  EXPECT_LT(cut.doubt(), CutOptions().max_doubt);
  const auto polar_of = [&](TriangleId t) { return std::acos(unit(ball.model.centroid(t)).z); };
  for (const TriangleId t : ball.mesh.triangles.ids()) {
    if (polar_of(t) > 1.1 && polar_of(t) < 2) {
      EXPECT_EQ(cut.under[t], 1) << polar_of(t);
    }
    if (polar_of(t) < 0.9 || polar_of(t) > 2.3) {
      EXPECT_EQ(cut.under[t], 0) << polar_of(t);
    }
  }
  // What is cut where the rim is torn is counted once.
  RimLoop& loop = ball.rim.loops[0];
  loop.inner.assign(loop.size(), 0);
  for (std::size_t i = 0; i < 10; ++i) loop.inner[i] = 1;
  const RegionCut torn = ball.cut();
  ball.scans.clear();
  const RegionCut torn_alone = ball.cut();
  EXPECT_GT(torn.scan_ends, 50U);
  EXPECT_GT(torn_alone.cut_edges, 4U);
  EXPECT_LT(torn.cut_edges, cut.cut_edges + 2 * torn_alone.cut_edges);
  EXPECT_LT(torn.cut_length, cut.cut_length + 2 * torn_alone.cut_length);
  loop.inner.clear();
  const RegionCut without = ball.cut();
  EXPECT_EQ(without.cut_edges, 0U);
  EXPECT_GT(without.under_facets, cut.under_facets + 1000);
}

// A third of the rim is missing, and the shortest way would leave what is between it and the arc.
// The samples of a boss over all of the disk say that this goes, too; they are not asked where the
// rim tells all.
TEST(CutRegions, SamplesHaveASayWhereTheRimIsInDoubt) {
  RimOnAMesh plane(grid_plane(30), torn_rim(10, 30));
  std::vector<Point> boss;
  for (double x = 8; x < 22; x += 0.6) {
    for (double y = 8; y < 22; y += 0.6) {
      if (distance({x, y, 0}, middle) < radius - 0.5) boss.push_back({x, y, 3});
    }
  }
  plane.scans = {{boss, 0.6}};
  std::size_t asked = 0;
  const OutwardNormals outward = [&](std::size_t scan) {
    EXPECT_EQ(scan, 0U);
    ++asked;
    return std::vector<Outward>(boss.size(), {{0, 0, 1}});
  };
  const auto cut = [&](const OutwardNormals& normals) {
    return cut_under_cloud(plane.model, plane.certain(), std::span(&plane.rim, 1), plane.scans, {},
                           normals);
  };
  const auto left = [&](const RegionCut& found) {  // well within the disk, but not under the cloud
    std::size_t count = 0;
    const TriangleSet border = plane.certain();
    for (const TriangleId t : plane.mesh.triangles.ids()) {
      const bool inside = border[t] == 0 && plane.radius_of(t) < radius - 1.2;
      count += inside && found.under[t] == 0 ? 1U : 0U;
      if (plane.radius_of(t) > radius + 1) {
        EXPECT_EQ(found.under[t], 0);
      }
    }
    return count;
  };
  const RegionCut without = cut({});
  EXPECT_EQ(without.said_under.size(), 0U);
  EXPECT_GT(left(without), 15U);
  const RegionCut with = cut(outward);
  EXPECT_EQ(asked, 1U);
  EXPECT_GT(with.said_under.size(), 30U);
  EXPECT_EQ(left(with), 0U);

  RimOnAMesh whole(grid_plane(30), torn_rim(0, 0));
  const auto asked_of_whole = [&] {
    asked = 0;
    cut_under_cloud(whole.model, whole.certain(), std::span(&whole.rim, 1), plane.scans, {},
                    outward);
    return asked;
  };
  EXPECT_EQ(asked_of_whole(), 0U);
  whole.rim.leaves_model = true;
  EXPECT_EQ(asked_of_whole(), 1U);
}

// The floor of a pocket is smaller than its mouth, around which the loop says "outside".
TEST(CutRegions, WhatIsNearADisprovedFacetOfAnIslandGoes) {
  RimLoop mouth = testing::circle(40, middle, 6);
  for (std::size_t i = 0; i < mouth.size(); ++i) {
    mouth.apexes[i] = mouth.points[i] + (mouth.points[i] - mouth.apexes[i]);
  }
  CloudRim rim = rim_of({testing::circle(80, middle, 12), mouth});
  rim.leaves_model = true;
  RimOnAMesh plane(grid_plane(30), rim);
  std::vector<Point> floor;
  for (double x = 11; x <= 19; x += 0.6) {
    for (double y = 11; y <= 19; y += 0.6) {
      if (distance({x, y, 0}, middle) < 4) floor.push_back({x, y, -4});
    }
  }
  plane.scans = {{floor, 0.6}};
  const auto num_left = [&](double island_reach) {
    CutOptions options;
    options.disproved.island_reach = island_reach;
    const TriangleSet border = plane.certain();
    const RegionCut cut = cut_under_cloud(plane.model, border, std::span(&plane.rim, 1),
                                          plane.scans, options, [&](std::size_t) {
                                            return std::vector<Outward>(floor.size(), {{0, 0, 1}});
                                          });
    std::size_t count = 0;
    for (const TriangleId t : plane.mesh.triangles.ids()) {
      count += border[t] == 0 && cut.under[t] == 0 && plane.radius_of(t) < 5 ? 1U : 0U;
    }
    return count;
  };
  EXPECT_GT(num_left(0), 20U);
  EXPECT_EQ(num_left(2.5), 0U);
}

// The sheet reaches far beyond the rim: to have all of the model go would contradict less than to
// have what lies under it stay.
TEST(CutRegions, SamplesAreNotBelievedIfTooMuchWouldGo) {
  RimOnAMesh plane(grid_plane(30), torn_rim(10, 30));
  std::vector<Point> sheet;
  for (double x = 5; x < 25; x += 0.6) {
    for (double y = 5; y < 25; y += 0.6) sheet.push_back({x, y, 3});
  }
  plane.scans = {{sheet, 0.6}};
  const auto cut = [&](const CutOptions& options) {
    return cut_under_cloud(plane.model, plane.certain(), std::span(&plane.rim, 1), plane.scans,
                           options, [&](std::size_t) {
                             return std::vector<Outward>(sheet.size(), {{0, 0, 1}});
                           });
  };
  CutOptions options;
  const RegionCut far = cut(options);
  EXPECT_GT(far.said_under.size(), 300U);
  EXPECT_GT(far.under_facets, 1500U);
  options.disproved.reach = 5.5;
  const RegionCut near = cut(options);
  EXPECT_EQ(near.said_under.size(), 0U);
  EXPECT_EQ(near.under, plane.cut().under);
  EXPECT_EQ(near.doubt(), plane.cut().doubt());
}

// Where one sample lies beyond all that would go, its box tells nothing. Then only a rim with more
// seams than a clear one has makes that the ends of the scan are looked for, one of several, too.
TEST(CutRegions, EndsAreLookedForUnlessAllRimsAreClear) {
  CloudRim clear = rim_of({testing::cap_rim(60, {0, 0, -1}, std::numbers::pi - 1)});
  clear.median_edge = clear.spacing;
  clear.rim_edges = 60;
  clear.seam_edges = 3;
  CloudRim torn = clear;
  torn.seam_edges = 4;
  RimOnAMesh ball(testing::sphere(4), clear);
  std::vector<Point> belt = {{1.1, 1.1, 1.1}, {-1.1, -1.1, -1.1}};
  for (double polar = 1; polar < 2.1; polar += 0.05) {
    for (int k = 0; k < 120; ++k) {
      const double angle = 2 * std::numbers::pi * k / 120;
      belt.push_back(
          {std::sin(polar) * std::cos(angle), std::sin(polar) * std::sin(angle), std::cos(polar)});
    }
  }
  ball.scans = {{belt, 0.05}};
  const auto ends = [&](const std::vector<CloudRim>& rims) {
    return cut_under_cloud(ball.model, ball.certain(), rims, ball.scans).scan_ends;
  };
  EXPECT_EQ(ends({clear}), 0U);
  EXPECT_GT(ends({torn}), 20U);
  EXPECT_EQ(ends({clear, clear}), 0U);
  EXPECT_EQ(ends({clear, torn}), ends({torn}));
}

}  // namespace
}  // namespace cocoon
