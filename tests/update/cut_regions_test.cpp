#include "update/cut_regions.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

#include "tests/mesh_gallery.h"
#include "tests/update/hand_made_models.h"
#include "tests/update/torn_rims.h"
#include "update/choose_regions.h"
#include "update/overlapping_facets.h"
#include "update/rim_angles.h"

namespace cocoon {
namespace {

using testing::circle;
using testing::grid_plane;
using testing::middle;
using testing::radius;
using testing::rim_of;
using testing::RimOnAMesh;
using testing::torn_rim;

TEST(CutRegions, AWholeRimIsAllOfTheCut) {
  const RimOnAMesh plane(grid_plane(30), torn_rim(0, 0));
  const TriangleSet border = plane.certain();
  EXPECT_EQ(border, plane.border.facets);
  const RegionCut cut = plane.cut();
  EXPECT_TRUE(RegionCut().is_empty());
  EXPECT_FALSE(cut.is_empty());
  EXPECT_EQ(cut.cut_edges, 0U);
  EXPECT_EQ(cut.contradicted, 0);
  EXPECT_EQ(cut.doubt(), 0);
  for (const TriangleId t : plane.mesh.triangles.ids()) {
    if (border[t] == 0) {
      EXPECT_EQ(cut.under[t] != 0, plane.radius_of(t) < radius);
    }
  }
}

// A sixth of the rim is missing: the cut is the chord, which is at most 0.8 from the arc.
TEST(CutRegions, AMissingStretchIsCutTheShortestWay) {
  const RimOnAMesh plane(grid_plane(30), torn_rim(20, 30));
  const TriangleSet border = plane.certain();
  const RegionCut cut = plane.cut();
  EXPECT_GE(cut.cut_edges, 4U);
  EXPECT_LE(cut.cut_length * plane.rim.median_edge, 2 * radius);
  EXPECT_LT(cut.doubt(), 0.35);
  std::size_t under = 0;
  for (const TriangleId t : plane.mesh.triangles.ids()) {
    if (border[t] != 0) continue;
    under += cut.under[t];
    if (plane.radius_of(t) < radius - 2.3) {
      EXPECT_EQ(cut.under[t], 1);
    }
    if (plane.radius_of(t) > radius + 1) {
      EXPECT_EQ(cut.under[t], 0);
    }
  }
  EXPECT_EQ(under, cut.under_facets);
}

// Three points of the rim are where they do not belong. The mean angle of the region between the
// way there and the way back may be anything; that it is cut off from the cloud by the rest tells.
TEST(CutRegions, AStretchInTheWrongPlaceIsOutvoted) {
  CloudRim rim = torn_rim(0, 1);
  RimLoop& loop = rim.loops[0];
  for (std::size_t i = 13; i < 16; ++i) {
    const Vec3 out = 1.4 * (loop.points[i] - middle);
    loop.points[i] = loop.points[i] + out;
    loop.apexes[i] = loop.points[i] + out;  // the cloud seems to be outside there
  }
  loop.inner[12] = loop.inner[15] = 1;
  const RimOnAMesh plane(grid_plane(30), rim);
  const RegionCut cut = plane.cut();
  EXPECT_GT(cut.contradicted + cut.cut_length, 0);
  EXPECT_LT(cut.doubt(), 0.5);
  std::size_t astray = 0;
  for (const TriangleId t : plane.mesh.triangles.ids()) {
    if (plane.radius_of(t) > radius + 2) astray += cut.under[t];
    if (plane.radius_of(t) < radius - 3) {
      EXPECT_EQ(cut.under[t], 1) << plane.radius_of(t);
    }
  }
  EXPECT_LE(astray, 3U);  // between its facets
}

TEST(CutRegions, ADetourIsNoPartOfTheBorder) {
  RimOnAMesh plane(grid_plane(30), torn_rim(0, 0));
  LoopBorder& band = plane.border.loops[0];
  // The first edge goes around the whole circle.
  std::vector<TriangleId> detour(band.facets.rbegin(), band.facets.rend());
  for (const TriangleId t : plane.mesh.triangles.ids()) {
    if (plane.radius_of(t) > 10 && plane.radius_of(t) < 11) detour.push_back(t);
  }
  LoopBorder longer;
  longer.facets = detour;
  longer.begin.assign(band.begin.size(), static_cast<std::uint32_t>(detour.size()));
  longer.begin[0] = 0;
  plane.border.loops = {longer};
  const TriangleSet none = plane.certain();
  EXPECT_EQ(std::count(none.begin(), none.end(), 1), 0);
  const TriangleSet all = plane.certain({.max_detour = 1e9});
  EXPECT_GT(std::count(all.begin(), all.end(), 1), 100);
}

// The order of facets and scaling by a power of two change nothing.
TEST(CutRegions, DependsOnTheShapeOnly) {
  const RimOnAMesh plane(grid_plane(30), torn_rim(20, 34));
  auto [other, order] = testing::shuffled(plane.mesh);
  for (Point& p : other.points) p = 1024 * p;
  const RegionCut cut = plane.cut();
  const RegionCut again = RimOnAMesh(other, scaled(plane.rim, 1024)).cut();
  for (std::size_t i = 0; i < order.size(); ++i) {
    EXPECT_EQ(again.under[TriangleId(i)], cut.under[order[i]]);
  }
  EXPECT_EQ(again.cut_edges, cut.cut_edges);
  EXPECT_EQ(again.cut_length, cut.cut_length);
}

// A rim around the tube of a torus has both sides everywhere: a cut costs as much as what it keeps.
TEST(CutRegions, ARimThatTellsNothingIsDoubtful) {
  constexpr double tube = 0.3;
  constexpr std::size_t n = 40;
  std::vector<Point> points;
  for (std::size_t j = 0; j < n; ++j) {
    const double v = 2 * std::numbers::pi * (static_cast<double>(j) + 0.3) / n;
    points.push_back(testing::torus_point(0.31, v, tube));
  }
  std::vector<Vec3> normals;
  for (const Point& p : points) normals.push_back(unit(p - testing::torus_point(0.31, 0, 0)));
  CloudRim rim = rim_of({testing::loop_towards(points, normals, testing::torus_point(0.61, 0, 0))});
  rim.median_edge = rim.spacing;
  const RimOnAMesh torus(testing::torus(80, 30, tube), rim);
  EXPECT_GT(torus.cut().doubt(), CutOptions().max_doubt);
  EXPECT_EQ(torus.cut({.seed_reach = 0}).doubt(), 1);
  EXPECT_EQ(torus.cut({.seed_reach = 0}).under_facets, 0U);
}

// The rim around what the scan shows, and another loop in its midst beyond which a few facets lie.
RimOnAMesh with_inner_loop(std::size_t inner_edges) {
  constexpr std::size_t n = 16;
  CloudRim rim = torn_rim(0, 0);
  RimLoop loop = circle(n, middle, 1.4);
  for (std::size_t i = 0; i < n; ++i) {
    loop.apexes[i] = loop.points[i] + (loop.points[i] - middle);
  }
  loop.inner.assign(n, 0);
  std::fill_n(loop.inner.begin(), inner_edges, std::uint8_t{1});
  rim.loops.push_back(loop);
  rim.seam_edges = inner_edges;
  return RimOnAMesh(grid_plane(30), rim);
}

// A whole loop is that around a hole in the scan, and what lies beyond it stays, be it small. What
// is left of a seam leaves a few facets outside, with cloud all around: they are none.
TEST(CutRegions, TinyPartsBesideAPartialLoopAreNotOutside) {
  const RegionCut whole = with_inner_loop(0).cut();
  EXPECT_TRUE(whole.splinters.empty());
  const RimOnAMesh torn = with_inner_loop(2);
  const RegionCut cut = torn.cut();
  ASSERT_FALSE(cut.splinters.empty());
  EXPECT_LT(cut.splinters.size(), CutOptions().min_outside_facets);
  for (const TriangleId t : cut.splinters) {
    EXPECT_LT(torn.radius_of(t), 2);
    EXPECT_EQ(cut.under[t], 0);
    EXPECT_EQ(whole.under[t], 0);
  }
  EXPECT_TRUE(torn.cut({.min_outside_facets = cut.splinters.size()}).splinters.empty());
  EXPECT_EQ(torn.cut({.min_outside_facets = cut.splinters.size() + 1}).splinters, cut.splinters);
}

TEST(CutRegions, TinyPartsAreOfNoRegion) {
  const RimOnAMesh torn = with_inner_loop(2);
  const auto cut = [&](const CutOptions& options) {
    const std::vector<Scan> scans(1);
    const std::vector<std::size_t> joined = {0};
    const std::vector<std::uint8_t> is_cut = {1};
    return cut_regions(torn.model,
                       {std::span(&torn.rim, 1), std::span(&torn.border, 1), scans, joined, is_cut},
                       options);
  };
  const CutRegions found = cut({});
  ASSERT_FALSE(found.cuts[0].splinters.empty());
  for (const TriangleId t : found.cuts[0].splinters) {
    EXPECT_TRUE(found.regions.region_of_facet[t].is_none());
  }
  const CutRegions kept = cut({.min_outside_facets = 0});
  EXPECT_TRUE(kept.cuts[0].splinters.empty());
  for (const TriangleId t : found.cuts[0].splinters) {
    EXPECT_FALSE(kept.regions.region_of_facet[t].is_none());
  }
}

// If that is all that is outside it is no splinter.
TEST(CutRegions, TheLastPartOutsideStays) {
  RimOnAMesh torn = with_inner_loop(2);
  torn.rim.loops.erase(torn.rim.loops.begin());
  torn.border.loops.erase(torn.border.loops.begin());
  const RegionCut cut = torn.cut();
  EXPECT_GT(cut.under_facets, 1000U);
  EXPECT_TRUE(cut.splinters.empty());
}

// Of joined clouds lengths are in the shorter median edges.
TEST(CutRegions, LengthsAreInTheShortestMedianEdges) {
  const RimOnAMesh scene(grid_plane(30), torn_rim(0, 0));
  CloudRim fine = scene.rim;
  fine.median_edge = 0.5;
  CloudRim coarse = scene.rim;
  coarse.median_edge = 2;
  const auto seeds = [&](const std::vector<CloudRim>& rims) {
    return cut_under_cloud(scene.model, scene.certain(), rims).seeds_under;
  };
  EXPECT_NEAR(seeds({fine}), 4 * seeds({coarse}), 0.01 * seeds({fine}));
  EXPECT_EQ(seeds({fine, coarse}), seeds({fine}));
  EXPECT_EQ(seeds({coarse, fine}), seeds({fine}));
}

// Two halves of a disk: each has its rim in the midst of the other, which is marked as shared.
TEST(CutRegions, JoinedCloudsAreCutAsOne) {
  const TriangleMesh mesh = grid_plane(30);
  const ModelIndex model(mesh);
  std::vector<CloudRim> rims(2, torn_rim(0, 0));
  for (std::size_t i = 0; i < 60; ++i) {
    rims[0].loops[0].inner[i] = i >= 28 ? 1 : 0;
    rims[1].loops[0].inner[i] = i < 32 && i > 2 ? 1 : 0;
  }
  for (CloudRim& rim : rims) {
    rim.seam_edges = 0;
    rim.shared_edges = 30;
  }
  std::vector<Border> borders;
  for (const CloudRim& rim : rims) {
    borders.push_back(trace_border(model, rim, overlapping_facets(model, rim)));
  }
  const std::vector<Scan> scans(2);  // where they end is not known
  const std::vector<std::uint8_t> both = {1, 1};
  const CutRegions joined =
      cut_regions(model, {rims, borders, scans, std::vector<std::size_t>{0, 0}, both});
  EXPECT_EQ(joined.under[0], joined.under[1]);
  EXPECT_LE(joined.cuts[0].cut_edges, 2U);
  for (const TriangleId t : mesh.triangles.ids()) {
    const RegionId r = joined.regions.region_of_facet[t];
    if (r.is_none()) continue;
    EXPECT_EQ(joined.under[0][r] != 0, distance(model.centroid(t), middle) < radius);
  }
  // Alone each is cut across.
  const CutRegions alone =
      cut_regions(model, {rims, borders, scans, std::vector<std::size_t>{0, 1}, both});
  EXPECT_GT(alone.cuts[0].cut_edges, 5U);
  EXPECT_GT(alone.cuts[1].cut_edges, 5U);
}

// Two clouds side by side, one with a torn rim: each region lies as a whole under each of them, or
// outside, and what the cut says is replaced.
TEST(CutRegions, RegionsLieAsAWholeUnderEachCloud) {
  const TriangleMesh mesh = grid_plane(40);
  const ModelIndex model(mesh);
  const Point left = {10.1, 20.2, 0};
  const Point right = {29.1, 20.3, 0};
  std::vector<CloudRim> rims;
  for (const Point& p : {left, right, right}) {
    rims.push_back(rim_of({circle(60, p, 6)}));
    rims.back().median_edge = rims.back().spacing;
  }
  for (const std::size_t c : {std::size_t{1}, std::size_t{2}}) {
    rims[c].loops[0].inner.assign(60, 0);
    for (std::size_t i = 0; i < 10; ++i) rims[c].loops[0].inner[30 * c - 20 + i] = 1;
    rims[c].seam_edges = 10;
  }
  std::vector<Border> borders;
  for (const CloudRim& rim : rims) {
    borders.push_back(trace_border(model, rim, overlapping_facets(model, rim)));
  }
  const std::vector<Scan> scans(3);  // where they end is not known
  const std::vector<std::size_t> alone = {0, 1, 2};
  std::vector<std::uint8_t> partial;
  for (const CloudRim& rim : rims) partial.push_back(rim.is_partial() ? 1 : 0);
  const std::vector<std::uint8_t> is_cut = clouds_to_cut(partial, alone);
  EXPECT_EQ(is_cut, (std::vector<std::uint8_t>{0, 1, 1}));
  const CutRegions found = cut_regions(model, {rims, borders, scans, alone, is_cut});
  EXPECT_TRUE(found.under[0].empty());
  std::vector<RegionAngles> angles;
  for (std::size_t c = 0; c < rims.size(); ++c) {
    ASSERT_TRUE(c == 0 || found.under[c].size() == found.regions.regions.size());
    angles.push_back(mean_rim_angles(model, found.regions, rims[c].loops[0], borders[c].loops[0]));
    angles.back().cloud = static_cast<std::uint32_t>(c);
    for (const TriangleId t : mesh.triangles.ids()) {
      const RegionId r = found.regions.region_of_facet[t];
      if (c > 0 && !r.is_none()) {
        EXPECT_EQ(found.under[c][r], found.cuts[c].under[t]);
      }
    }
  }
  const RegionChoice choice = choose_regions(angles, 3, {}, found.under);
  EXPECT_EQ(choice.status, ChoiceStatus::ok);
  for (const TriangleId t : mesh.triangles.ids()) {
    const RegionId r = found.regions.region_of_facet[t];
    if (r.is_none()) continue;
    const Point p = model.centroid(t);
    const double nearer = std::min(distance(p, left), distance(p, right));
    if (nearer < 3.5) {
      EXPECT_EQ(choice.replaced[r], 1);
    }
    if (nearer > 7) {
      EXPECT_EQ(choice.replaced[r], 0);
    }
  }
  for (const CloudChoice& cloud : choice.clouds) EXPECT_GT(cloud.margin, 1);
}

// Two triangles, a torn rim across both: the border is that of the whole rim. Beside a triangle
// within the rim it is cut.
TEST(CutRegions, NothingIsMissingInLargeFacets) {
  const auto is_cut = [](const TriangleMesh& mesh) {
    const ModelIndex model(mesh);
    const std::vector<CloudRim> rims = {torn_rim(20, 24)};
    const std::vector<Border> borders = {
        trace_border(model, rims[0], overlapping_facets(model, rims[0]))};
    const std::vector<std::uint8_t> all = {1};
    const CutRegions found =
        cut_regions(model, {rims, borders, std::vector<Scan>(1), std::vector<std::size_t>{0}, all});
    EXPECT_EQ(found.cuts[0].is_empty(), found.is_cut[0] == 0);
    EXPECT_EQ(found.under[0].empty(), found.is_cut[0] == 0);
    return found.is_cut[0] != 0;
  };
  const TriangleMesh square = gallery::make_mesh(
      {{-50, -50, 0}, {80, -50, 0}, {80, 80, 0}, {-50, 80, 0}}, {{0, 1, 2}, {0, 2, 3}});
  EXPECT_FALSE(is_cut(square));
  EXPECT_TRUE(is_cut(grid_plane(30)));
}

TEST(CutRegions, CloudsAreCutWithThoseTheyAreJoinedWith) {
  using Flags = std::vector<std::uint8_t>;
  EXPECT_EQ(clouds_to_cut(Flags{0, 1, 0, 0}, std::vector<std::size_t>{0, 0, 2, 0}),
            (Flags{1, 1, 0, 1}));
}

// A disk in a larger one, both torn on the same side: the cut of the second cloud parts what lies
// under the first one, and both parts do.
TEST(CutRegions, PartsOfARegionLieUnderWhoeverItLayUnder) {
  const TriangleMesh mesh = grid_plane(30);
  const ModelIndex model(mesh);
  std::vector<CloudRim> rims(2, torn_rim(20, 30));
  rims[0].loops[0].points = circle(60, middle, 9).points;
  rims[0].loops[0].apexes = circle(60, middle, 9).apexes;
  std::vector<Border> borders;
  TriangleSet certain(mesh.triangles.size(), 0);
  for (const CloudRim& rim : rims) {
    borders.push_back(trace_border(model, rim, overlapping_facets(model, rim)));
    certain_border(model, rim, borders.back().loops, {}, certain);
  }
  const std::vector<Scan> scans(2);  // where they end is not known
  const CutRegions found = cut_regions(model, {rims, borders, scans, std::vector<std::size_t>{0, 1},
                                               std::vector<std::uint8_t>{1, 1}});
  ASSERT_EQ(found.regions.regions.size(), 3U);
  std::vector<std::size_t> facets(3, 0);
  for (const TriangleId t : mesh.triangles.ids()) {
    const RegionId r = found.regions.region_of_facet[t];
    EXPECT_EQ(r.is_none(), certain[t] != 0);
    if (r.is_none()) continue;
    ++facets[r.index()];
    for (std::size_t c = 0; c < 2; ++c) EXPECT_EQ(found.under[c][r], found.cuts[c].under[t]);
  }
  for (const RegionId r : found.regions.regions.ids()) {
    EXPECT_EQ(found.regions.regions[r].facets, facets[r.index()]);
  }
}

// Whichever of them is said to be cut.
TEST(CutRegions, JoinedCloudsAreCutTogether) {
  const TriangleMesh mesh = testing::grid_plane(40);
  const ModelIndex model(mesh);
  std::vector<CloudRim> rims;
  std::vector<Border> borders;
  for (const double x : {10.13, 30.13}) {
    CloudRim rim = testing::rim_of({testing::circle(40, {x, 20.07, 0}, 6)});
    rim.median_edge = rim.spacing;
    borders.push_back(trace_border(model, rim, overlapping_facets(model, rim)));
    rims.push_back(std::move(rim));
  }
  const std::vector<Scan> scans(2);
  const std::vector<std::size_t> joined = {0, 0};
  using Flags = std::vector<std::uint8_t>;
  for (const Flags& flags : {Flags{0, 1}, Flags{1, 0}, Flags{1, 1}}) {
    const CutRegions cut = cut_regions(model, {rims, borders, scans, joined, flags});
    EXPECT_EQ(cut.is_cut, Flags({1, 1}));
    EXPECT_EQ(cut.regions.regions.size(), 3U);
    EXPECT_EQ(cut.under[0].size(), 3U);
    EXPECT_EQ(cut.under[1], cut.under[0]);
  }
}

}  // namespace
}  // namespace cocoon
