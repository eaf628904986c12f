#include "update/cloud_rim.h"

#include <algorithm>
#include <array>
#include <gtest/gtest.h>
#include <utility>
#include <vector>

#include "geom/random/random.h"
#include "tests/mesh_gallery.h"
#include "tests/update/hand_made_models.h"

namespace cocoon {
namespace {

// The edges of a loop with their apexes, whichever way and from wherever it runs.
std::vector<std::array<Point, 3>> edges_of(const RimLoop& loop) {
  std::vector<std::array<Point, 3>> edges;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const auto [low, high] = std::minmax(loop.points[i], loop.points[loop.next(i)]);
    edges.push_back({low, high, loop.apexes[i]});
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}
bool same_edges(const RimLoop& a, const RimLoop& b) { return edges_of(a) == edges_of(b); }

TEST(CloudRim, OutlineOfASquare) {
  const CloudRim rim = cloud_rim(testing::grid_plane(10));
  ASSERT_EQ(rim.loops.size(), 1U);
  const RimLoop& loop = rim.loops[0];
  ASSERT_EQ(loop.size(), 40U);
  EXPECT_DOUBLE_EQ(loop.perimeter, 40);
  EXPECT_DOUBLE_EQ(rim.spacing, 1);
  EXPECT_EQ(loop.points[0], (Point{0, 0, 0}));
  for (std::size_t i = 0; i < loop.size(); ++i) {
    EXPECT_DOUBLE_EQ(distance(loop.points[i], loop.points[loop.next(i)]), 1);
    EXPECT_EQ(std::abs(loop.normals[i].z), 1);
    EXPECT_EQ(loop.normals[i], loop.normals[0]);
    // The apex is the third corner of a triangle at this very edge, inside the square.
    const Point middle = 0.5 * (loop.points[i] + loop.points[loop.next(i)]);
    EXPECT_LE(distance(loop.apexes[i], middle), 1.2);
    EXPECT_GT(norm(loop.apexes[i] - middle), 0.5);
  }
}

// A long strip, narrow along its length: most edges at the rim are short, most of the surface are
// not.
TEST(CloudRim, TheSpacingIsThatOfTheRim) {
  TriangleMesh strip = gallery::open_patch(1, 30);
  for (Point& p : strip.points) p = {0.5 * p.x, 3 * p.y, 0};
  const CloudRim rim = cloud_rim(strip);
  ASSERT_EQ(rim.loops.size(), 1U);
  EXPECT_EQ(rim.spacing, 0.5);
  EXPECT_EQ(rim.median_edge, 3);
}

TEST(CloudRim, DoesNotDependOnTheNumbering) {
  const TriangleMesh mesh = testing::with_hole(testing::grid_plane(12), 3, 9);
  const CloudRim expected = cloud_rim(mesh);
  ASSERT_EQ(expected.loops.size(), 2U);
  Random random(3);
  for (int round = 0; round < 5; ++round) {
    std::vector<std::size_t> order(mesh.points.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    random.shuffle(order);
    TriangleMesh other;
    other.points = IdVector<VertexId, Point>(mesh.points.size());
    for (const VertexId v : mesh.points.ids()) {
      other.points[VertexId(order[v.index()])] = mesh.points[v];
    }
    std::vector<Triangle> triangles = mesh.triangles.raw();
    random.shuffle(triangles);
    for (Triangle t : triangles) {
      for (VertexId& v : t) v = VertexId(order[v.index()]);
      if (random.uniform() < 0.5) std::swap(t[0], t[1]);
      other.triangles.push_back(t);
    }
    const CloudRim rim = cloud_rim(other);
    ASSERT_EQ(rim.loops.size(), 2U);
    for (std::size_t l = 0; l < 2; ++l) {
      EXPECT_TRUE(same_edges(rim.loops[l], expected.loops[l]));
    }
  }
}

TEST(CloudRim, ClosedSurfaceHasNone) {
  const CloudRim rim = cloud_rim(testing::sphere(3));
  EXPECT_TRUE(rim.loops.empty());
  EXPECT_EQ(rim.pin_holes, 0U);
  EXPECT_GT(rim.spacing, 0);
}

TEST(CloudRim, HolesAndPinHoles) {
  const CloudRim wide = cloud_rim(testing::with_hole(testing::grid_plane(12), 4, 8));
  ASSERT_EQ(wide.loops.size(), 2U);
  EXPECT_EQ(wide.loops[0].size(), 48U);
  EXPECT_EQ(wide.loops[1].size(), 16U);
  EXPECT_EQ(wide.pin_holes, 0U);

  const CloudRim narrow = cloud_rim(testing::with_hole(testing::grid_plane(12), 5, 7));
  ASSERT_EQ(narrow.loops.size(), 1U);
  EXPECT_EQ(narrow.pin_holes, 1U);

  const RimOptions accept_all = {.loops = {.min_loop_edges = 3, .min_perimeter_in_edges = 0}};
  EXPECT_EQ(cloud_rim(testing::with_hole(testing::grid_plane(12), 5, 7), accept_all).loops.size(),
            2U);
}

TEST(CloudRim, SmallPatchIsNotAPinHole) {
  const CloudRim rim = cloud_rim(testing::grid_plane(1));  // two triangles, rim of four edges
  ASSERT_EQ(rim.loops.size(), 1U);
  EXPECT_EQ(rim.loops[0].size(), 4U);
  EXPECT_EQ(rim.pin_holes, 0U);
}

// Its triangles cannot agree, but those along its one loop do.
TEST(CloudRim, NormalsOfAOneSidedPartAgreeFromEdgeToEdge) {
  TriangleMesh strip = gallery::moebius_strip(40);
  for (const bool turned : {false, true}) {  // every third triangle
    for (const TriangleId t : strip.triangles.ids()) {
      if (turned && t.index() % 3 == 0) std::swap(strip.triangles[t][1], strip.triangles[t][2]);
    }
    const CloudRim rim = cloud_rim(strip);
    ASSERT_EQ(rim.loops.size(), 1U);
    const RimLoop& loop = rim.loops[0];
    EXPECT_TRUE(loop.one_sided);
    for (std::size_t i = 0; i < loop.size(); ++i) {
      EXPECT_GT(dot(loop.normals[i], loop.normals[loop.next(i)]), 0.9) << i;
    }
  }
  EXPECT_FALSE(cloud_rim(gallery::open_patch(20, 20)).loops.at(0).one_sided);
}

TEST(CloudRim, DebrisIsDiscarded) {
  TriangleMesh mesh = testing::grid_plane(10);
  const std::size_t vertices = mesh.points.size();
  const TriangleMesh crumb = testing::grid_plane(2);
  for (const Point& p : crumb.points) mesh.points.push_back(p + Vec3{-20, 0, 0});
  for (Triangle t : crumb.triangles) {
    for (VertexId& v : t) v = VertexId(v.index() + vertices);
    mesh.triangles.push_back(t);
  }
  const CloudRim rim = cloud_rim(mesh);
  EXPECT_EQ(rim.loops.size(), 1U);
  EXPECT_EQ(rim.small_components, 1U);
  const RimOptions keep_all = {.loops = {.min_component_share = 0}};
  EXPECT_EQ(cloud_rim(mesh, keep_all).loops.size(), 2U);
}

}  // namespace
}  // namespace cocoon
