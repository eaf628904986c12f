#include "update/cloud/wall_edges.h"

#include <algorithm>
#include <cstddef>
#include <gtest/gtest.h>
#include <optional>
#include <vector>

#include "tests/update/hand_made_models.h"

namespace cocoon {
namespace {

// A sheet of a given thickness, cut along x = 10: strips of a scan on both of its sides, five units
// wide, each with its rim, and a row of samples between them along the new edge, or elsewhere.
struct CutSheet {
  TriangleMesh model_mesh;
  std::vector<Point> cloud;
  CloudRim rim;

  explicit CutSheet(double thickness) : CutSheet(thickness, Point{10, 0, thickness / 2}) {}
  CutSheet(double thickness, std::optional<Point> row) {
    model_mesh = testing::block(20, 20, 2);
    for (Point& p : model_mesh.points) p.z *= thickness / 2;
    rim.spacing = rim.median_edge = 1;
    for (const double z : {0.0, thickness}) {
      rim.loops.push_back(strip(z));
      for (double x = 5; x <= 10; ++x) {
        for (double y = 4; y <= 16; ++y) cloud.push_back({x, y, z});
      }
    }
    for (double y = 4.5; row && y <= 16; ++y) cloud.push_back({row->x, y, row->z});
    for (RimLoop& loop : rim.loops) loop.inner.assign(loop.size(), 0);
    rim.loops[0].inner[0] = 1;  // a seam, so that it is told that the surface is torn
    rim.seam_edges = 1;
  }
  static RimLoop strip(double z) {
    std::vector<Point> points;
    for (double x = 5; x < 10; ++x) points.push_back({x, 4, z});
    for (double y = 4; y < 16; ++y) points.push_back({10, y, z});
    for (double x = 10; x > 5; --x) points.push_back({x, 16, z});
    for (double y = 16; y > 4; --y) points.push_back({5, y, z});
    const std::vector<Vec3> normals(points.size(), {0, 0, z == 0 ? -1.0 : 1.0});
    return testing::loop_towards(points, normals, {7.5, 10, z});
  }
  // Those along the new edge, and all others.
  std::vector<std::size_t> marked(const WallEdgeOptions& options = {}) {
    mark_wall_edges(ModelIndex(model_mesh), {{cloud}}, rim, options);
    std::vector<std::size_t> count = {0, 0};
    for (const RimLoop& loop : rim.loops) {
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const bool is_new = loop.points[i].x == 10 && loop.points[loop.next(i)].x == 10;
        count[is_new ? 0 : 1] += loop.is_inner(i) ? 1U : 0U;
      }
    }
    return count;
  }
};

TEST(WallEdges, AreSeamsAlongTheNewEdgeOfAThinWall) {
  CutSheet sheet(1.6);
  const std::vector<std::size_t> marked = sheet.marked();
  EXPECT_EQ(marked[0], 24U);
  EXPECT_LE(marked[1], 1U + 4U);  // that seam, and edges beside the corners
  EXPECT_GE(sheet.rim.wall_edges, 24U);
  EXPECT_EQ(sheet.rim.seam_edges, 1 + sheet.rim.wall_edges);
}

TEST(WallEdges, NeedASampleAroundTheCornerAndAnotherSide) {
  EXPECT_EQ(CutSheet(1.6, std::nullopt).marked(), (std::vector<std::size_t>{0, 1}));
  EXPECT_EQ(CutSheet(3.5).marked(), (std::vector<std::size_t>{0, 1}));
  EXPECT_EQ(CutSheet(1.6).marked({.thickest = 1.5}), (std::vector<std::size_t>{0, 1}));
  EXPECT_EQ(CutSheet(1.6).marked({.reach = 0}), (std::vector<std::size_t>{0, 1}));
}

// Samples between the two sides that are no new edge.
TEST(WallEdges, NeedASampleThatIsNotFartherIn) {
  const std::vector<std::size_t> none = {0, 1};
  EXPECT_EQ(CutSheet(1.6, Point{9.4, 0, 0.8}).marked(), none);
  EXPECT_GT(CutSheet(1.6, Point{9.4, 0, 0.8}).marked({.max_inward = 0.7})[0], 20U);
}

TEST(WallEdges, NeedAStepFromTheModel) {
  const std::vector<std::size_t> none = {0, 1};
  EXPECT_EQ(CutSheet(1.6, Point{10, 0, 0.2}).marked(), none);
  EXPECT_GT(CutSheet(1.6, Point{10, 0, 0.2}).marked({.min_step = 0.1})[0], 10U);
}

// Off the model all edges would be marked: then no rim would be left.
TEST(WallEdges, ARimHasToBeLeft) {
  CutSheet sheet(1.6);
  for (RimLoop& loop : sheet.rim.loops) {
    for (Point& p : loop.points) p.x += 30;
    for (Point& p : loop.apexes) p.x += 30;
  }
  for (Point& p : sheet.cloud) p.x += 30;
  mark_wall_edges(ModelIndex(sheet.model_mesh), {{sheet.cloud}}, sheet.rim);
  EXPECT_EQ(sheet.rim.wall_edges, 0U);
}

TEST(WallEdges, ARimWithoutSeamsStays) {
  CutSheet sheet(1.6);
  sheet.rim.loops[0].inner[0] = 0;
  sheet.rim.seam_edges = 0;
  EXPECT_EQ(sheet.marked(), (std::vector<std::size_t>{0, 0}));
  EXPECT_EQ(sheet.rim.wall_edges, 0U);
}

}  // namespace
}  // namespace cocoon
