#include "update/cloud/rim_seams.h"

#include <algorithm>
#include <cstddef>
#include <gtest/gtest.h>
#include <vector>

#include "tests/update/hand_made_models.h"

namespace cocoon {
namespace {

// The surface of a folded sheet: the flat part, and a wall that stands on its side x = 10, as two
// surfaces that do not join at the fold. All points belong to one cloud.
struct FoldedSheet {
  TriangleMesh floor = testing::grid_plane(10);
  std::vector<Point> cloud;
  FoldedSheet() {
    for (const Point& p : floor.points) cloud.push_back(p);
    for (int y = 0; y <= 10; ++y) {
      for (int z = 0; z <= 10; ++z) {
        cloud.push_back({10.9, static_cast<double>(y), static_cast<double>(z)});
      }
    }
  }
};

TEST(MarkRimSeams, EdgesWithCloudBeyondThem) {
  const FoldedSheet sheet;
  CloudRim rim = cloud_rim(sheet.floor);
  ASSERT_EQ(rim.loops.size(), 1U);
  mark_rim_seams(sheet.cloud, rim);
  ASSERT_EQ(rim.loops.size(), 1U);
  const RimLoop& loop = rim.loops[0];
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const bool at_fold = loop.points[i].x == 10 && loop.points[loop.next(i)].x == 10;
    EXPECT_EQ(loop.is_inner(i), at_fold) << i;
    const bool between = loop.points[i].x == 10 && loop.points[i].y > 0 && loop.points[i].y < 10;
    EXPECT_EQ(loop.is_inner_point(i), between) << i;
  }
  EXPECT_EQ(rim.rim_edges, 40U);
  EXPECT_EQ(rim.seam_edges, 10U);
  EXPECT_EQ(rim.seam_loops, 0U);
}

TEST(MarkRimSeams, ALoopOfSuchEdgesIsNoRim) {
  const TriangleMesh floor = testing::grid_plane(6);
  std::vector<Point> cloud;  // the floor goes on all around; its surface does not
  for (int x = -3; x <= 9; ++x) {
    for (int y = -3; y <= 9; ++y) {
      cloud.push_back({static_cast<double>(x), static_cast<double>(y), 0});
    }
  }
  CloudRim rim = cloud_rim(floor);
  mark_rim_seams(cloud, rim);
  EXPECT_TRUE(rim.loops.empty());
  EXPECT_EQ(rim.seam_loops, 1U);
}

// A square surface in the middle of one side of its cloud: the cloud ends along x = 0, and goes on
// beyond the other three sides.
struct SquareAtAnEnd {
  TriangleMesh square = testing::grid_plane(12);
  std::vector<Point> cloud;
  SquareAtAnEnd() {
    for (int x = 0; x <= 15; ++x) {
      for (int y = -3; y <= 15; ++y) {
        cloud.push_back({static_cast<double>(x), static_cast<double>(y), 0});
      }
    }
  }
};

TEST(MarkRimSeams, TheRimInALoopThatIsMostlySeamStays) {
  const SquareAtAnEnd scene;
  CloudRim rim = cloud_rim(scene.square);
  ASSERT_EQ(rim.loops.size(), 1U);
  mark_rim_seams(scene.cloud, rim);
  EXPECT_EQ(rim.rim_edges, 48U);
  EXPECT_EQ(rim.seam_edges, 36U);
  EXPECT_EQ(rim.seam_loops, 0U);
  EXPECT_EQ(rim.seamed_loops, 1U);
  ASSERT_EQ(rim.loops.size(), 1U);
  const RimLoop& loop = rim.loops[0];
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const bool is_end = loop.points[i].x == 0 && loop.points[loop.next(i)].x == 0;
    EXPECT_EQ(loop.is_inner(i), !is_end) << i;
  }
}

TEST(MarkRimSeams, AShortEndOfALoopThatIsMostlySeamIsNoRim) {
  const SquareAtAnEnd scene;
  const auto loops_with = [&](const RimSeamOptions& options) {
    CloudRim rim = cloud_rim(scene.square);
    mark_rim_seams(scene.cloud, rim, options);
    EXPECT_EQ(rim.loops.size() + rim.seam_loops, 1U);
    EXPECT_EQ(rim.loops.size(), rim.seamed_loops);
    return rim.loops.size();
  };
  EXPECT_EQ(loops_with({}), 1U);
  EXPECT_EQ(loops_with({.min_rim_run = 12}), 1U);
  EXPECT_EQ(loops_with({.min_rim_run = 13}), 0U);
  EXPECT_EQ(loops_with({.min_rim_length = 13}), 0U);
  EXPECT_EQ(loops_with({.min_rim_run = 0}), 0U);  // as if there were no such rule
}

// Three quarters are not more than three quarters.
TEST(MarkRimSeams, ALoopIsMostlySeamAboveTheShare) {
  const SquareAtAnEnd scene;
  for (const double share : {0.75, 0.74}) {
    CloudRim rim = cloud_rim(scene.square);
    mark_rim_seams(scene.cloud, rim, {.max_seam_share = share, .min_rim_run = 0});
    EXPECT_EQ(rim.seam_loops, share == 0.75 ? 0U : 1U);
  }
}

// The end of the cloud, 12 edges of length 1, is measured in median edges of the surface, not in
// those of the rim; and there is no rim without length.
TEST(MarkRimSeams, TheLengthOfARimIsInMedianEdges) {
  SquareAtAnEnd scene;
  const auto loops_with = [&](double length) {
    CloudRim rim = cloud_rim(scene.square);
    rim.median_edge = 1.5;
    mark_rim_seams(scene.cloud, rim, {.min_rim_length = length});
    return rim.loops.size();
  };
  EXPECT_EQ(loops_with(8), 1U);
  EXPECT_EQ(loops_with(8.1), 0U);
  for (int y = -3; y <= 15; ++y) scene.cloud.push_back({-1, static_cast<double>(y), 0});
  EXPECT_EQ(loops_with(0), 0U);
}

// Wherever the loop starts, its rim is one run: here in the middle of it.
TEST(MarkRimSeams, ARunGoesOnWhereTheLoopStarts) {
  const SquareAtAnEnd scene;
  CloudRim rim = cloud_rim(scene.square);
  ASSERT_EQ(rim.loops.size(), 1U);
  RimLoop& loop = rim.loops[0];
  const auto start = static_cast<std::ptrdiff_t>(
      std::find(loop.points.begin(), loop.points.end(), Point{0, 6, 0}) - loop.points.begin());
  std::rotate(loop.points.begin(), loop.points.begin() + start, loop.points.end());
  std::rotate(loop.apexes.begin(), loop.apexes.begin() + start, loop.apexes.end());
  mark_rim_seams(scene.cloud, rim, {.min_rim_run = 12});
  ASSERT_EQ(rim.loops.size(), 1U);
  EXPECT_EQ(rim.loops[0].inner_edges(), 36U);
}

// A few edges by chance without a sample in reach beyond them are none of the rim.
TEST(MarkRimSeams, ShortStretchesBetweenSeamsAreSeams) {
  SquareAtAnEnd scene;
  std::erase_if(scene.cloud, [](const Point& p) { return p.x > 12 && p.y > 4 && p.y < 8; });
  CloudRim rim = cloud_rim(scene.square);
  mark_rim_seams(scene.cloud, rim);
  ASSERT_EQ(rim.loops.size(), 1U);
  EXPECT_LT(rim.seam_edges, 36U);
  std::size_t inner = 0;
  for (std::size_t i = 0; i < rim.loops[0].size(); ++i) inner += rim.loops[0].is_inner(i) ? 1U : 0U;
  EXPECT_EQ(inner, 36U);
}

// The samples of an edge itself are not beyond it, however far that reaches.
TEST(MarkRimSeams, TheEndsOfAnEdgeAreNoCloudBeyondIt) {
  const TriangleMesh floor = testing::grid_plane(1);
  CloudRim rim = cloud_rim(floor);
  ASSERT_EQ(rim.loops.size(), 1U);
  mark_rim_seams(floor.points.raw(), rim, {.reach = 1.2});
  EXPECT_EQ(rim.seam_edges + rim.seam_loops, 0U);
}

// Of two pin-holes far from the rim one has cloud in it, a median edge beyond its edges.
TEST(MarkRimSeams, PinHolesThatAreSeamsGo) {
  const TriangleMesh floor = testing::grid_plane(20);
  CloudRim rim = cloud_rim(floor);
  const auto hole = [](const Point& at) {
    const std::vector<Point> corners = {at, at + Vec3{0, 2, 0}, at + Vec3{2, 2, 0},
                                        at + Vec3{2, 0, 0}};
    std::vector<Point> apexes;
    RimLoop loop;
    for (std::size_t k = 0; k < 4; ++k) {
      const Point middle = 0.5 * (corners[k] + corners[(k + 1) % 4]);
      apexes.push_back(middle + (middle - (at + Vec3{1, 1, 0})));
    }
    loop.points = corners;
    loop.apexes = apexes;
    return loop;
  };
  rim.pin_hole_loops = {hole({5, 5, 0}), hole({12, 12, 0})};
  std::vector<Point> cloud = floor.points.raw();
  std::erase_if(cloud, [](const Point& p) { return p == Point{6, 6, 0} || p == Point{13, 13, 0}; });
  cloud.push_back({6, 6, 0.1});
  mark_rim_seams(cloud, rim);
  ASSERT_EQ(rim.pin_hole_loops.size(), 1U);
  EXPECT_EQ(rim.pin_hole_loops[0].points[0], (Point{12, 12, 0}));
  EXPECT_EQ(rim.seam_loops, 0U);
}

// The surface of a grid leaves out the sample at its corner: behind the edge there the cloud ends.
TEST(MarkRimSeams, ALoneSampleIsNoCloudBeyondAnEdge) {
  const TriangleMesh floor = testing::grid_plane(10);
  constexpr VertexId corner(10U);  // of one triangle
  TriangleMesh surface;
  surface.points = floor.points;
  for (const Triangle& t : floor.triangles) {
    if (std::find(t.begin(), t.end(), corner) == t.end()) surface.triangles.push_back(t);
  }
  ASSERT_EQ(floor.points[corner], (Point{10, 0, 0}));
  ASSERT_EQ(surface.triangles.size(), 199U);
  const auto seam_edges = [&](const std::vector<Point>& cloud, const RimSeamOptions& options) {
    CloudRim rim = cloud_rim(surface);
    mark_rim_seams(cloud, rim, options);
    EXPECT_EQ(rim.seam_edges + rim.lone_edges, 1U);
    return rim.seam_edges;
  };
  std::vector<Point> cloud = floor.points.raw();
  EXPECT_EQ(seam_edges(cloud, {}), 0U);
  EXPECT_EQ(seam_edges(cloud, {.min_samples = 1}), 1U);
  cloud.push_back({10.6, 0.2, 0});
  EXPECT_EQ(seam_edges(cloud, {}), 1U);
  EXPECT_EQ(seam_edges(cloud, {.few_reach = 0.2}), 0U);
}

TEST(MarkRimSeams, AFreeRimHasNone) {
  const TriangleMesh floor = testing::grid_plane(10);
  CloudRim rim = cloud_rim(floor);
  mark_rim_seams(floor.points.raw(), rim);
  ASSERT_EQ(rim.loops.size(), 1U);
  EXPECT_EQ(rim.seam_edges, 0U);
}

// All lengths are in spacings of the rim or of the surface.
TEST(MarkRimSeams, AreTheSameAtAnySize) {
  const FoldedSheet sheet;
  const CloudRim rim = cloud_rim(sheet.floor);
  const RimSeamOptions options{.max_seam_share = 0.1, .min_rim_run = 1, .min_rim_length = 25};
  CloudRim expected = rim;
  mark_rim_seams(sheet.cloud, expected, options);
  ASSERT_EQ(expected.loops.size(), 1U);
  for (const double factor : {0.125, 64.0}) {
    std::vector<Point> cloud = sheet.cloud;
    for (Point& p : cloud) p = factor * p;
    CloudRim other = scaled(rim, factor);
    EXPECT_EQ(other.loops[0].perimeter, factor * rim.loops[0].perimeter);
    mark_rim_seams(cloud, other, options);
    ASSERT_EQ(other.loops.size(), 1U) << factor;
    EXPECT_EQ(other.loops[0].inner, expected.loops[0].inner);
    EXPECT_EQ(other.seamed_loops, 1U);
  }
}

}  // namespace
}  // namespace cocoon
