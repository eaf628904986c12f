#include "update/checks/lost_surface.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "tests/mesh_gallery.h"

namespace cocoon {
namespace {

// An update of a box after which `vertex` has gone, and with it the triangles there; all other
// points are as before.
struct BoxUpdate {
  TriangleMesh model = gallery::box(10, 10, 10);
  TriangleMesh updated;
  UpdateResult result;
  MeshChange change;
  std::vector<Point> cloud = {{0.1, 0, 0}, {0, 0.1, 0}, {0, 0, 0.1}};
  double spacing;

  BoxUpdate(VertexId vertex, double spacing_of_scan) : spacing(spacing_of_scan) {
    for (const VertexId v : model.points.ids()) {
      const bool goes = v == vertex;
      result.replacement.point_of_vertex.push_back(goes ? PointId() : PointId(v.value));
      change.vertex_map.push_back(goes ? VertexId() : v);
    }
    updated.points = model.points;
    for (const TriangleId t : model.triangles.ids()) {
      const Triangle& corners = model.triangles[t];
      const bool goes = std::find(corners.begin(), corners.end(), vertex) != corners.end();
      change.triangle_map.push_back(goes ? TriangleId() : TriangleId(updated.triangles.size()));
      if (!goes) updated.triangles.push_back(corners);
    }
  }

  LostSurface lost() const {
    return lost_surface(model, std::vector<Scan>{{cloud, spacing}}, result, change, updated);
  }
};

// Those that stay are all there; what the others lost is seen by places all over them.
TEST(LostSurface, SeesWhatLargeTrianglesLoseWithAVertex) {
  const BoxUpdate box(VertexId(0U), 0.5);
  const LostSurface lost = box.lost();
  EXPECT_EQ(lost.triangles.lost.size(), 0U);
  EXPECT_FALSE(lost.share);
  EXPECT_FALSE(lost.warns);
  EXPECT_GT(lost.large_share, 0.4);
  EXPECT_LE(lost.large_share, 0.5);  // six of twelve triangles, but for places beside the others
  // For a scan that is as coarse as the box they are not large.
  const BoxUpdate coarse(VertexId(0U), 5);
  EXPECT_EQ(coarse.lost().large_share, 0);
}

// What the update says is to go is no loss.
TEST(LostSurface, IsNotOfReplacedRegions) {
  BoxUpdate box(VertexId(0U), 0.5);
  UpdateResult& result = box.result;
  for (const TriangleId now : box.change.triangle_map) {
    result.regions.region_of_facet.push_back(now.is_none() ? RegionId(1U) : RegionId(0U));
  }
  result.replaced_groups = {RegionId(1U)};
  EXPECT_EQ(box.lost().large_share, 0);
  result.replaced_groups = {RegionId(2U)};
  EXPECT_GT(box.lost().large_share, 0.4);
}

// The spacing is 0.5, and the triangles that have gone are the corner of a box of 10: a triangle
// before them cuts it off, at a distance of 10 / sqrt(3) from the corner.
TEST(LostSurface, TellsOfSurfaceThatIsMadeUp) {
  BoxUpdate box(VertexId(0U), 0.5);
  EXPECT_FALSE(box.lost().makes_up);
  const Point corner = box.model.points[VertexId(0U)];
  Triangle beside;
  std::size_t count = 0;
  for (const VertexId v : box.model.points.ids()) {
    if (std::abs(distance(corner, box.model.points[v]) - 10) < 1e-9) beside.at(count++) = v;
  }
  ASSERT_EQ(count, 3U);
  box.updated.triangles.push_back(beside);
  const LostSurface lost = box.lost();
  EXPECT_TRUE(lost.makes_up);
  EXPECT_GT(lost.made_up.places, 30U);
  EXPECT_GT(lost.made_up.distance, 2.5);  // between the sides of the corner
  EXPECT_LT(lost.made_up.distance, 10 / 3.0 + 0.1);
  // What closes an opening has to be off the model, and large where the opening is.
  box.result.closed_openings.edges = 3;
  const LostSurface closed = box.lost();
  EXPECT_FALSE(closed.makes_up);
  EXPECT_LT(closed.large_share, lost.large_share);
}

TEST(LostSurface, IsNoneWhereAllIsKept) {
  const BoxUpdate box(VertexId(), 0.5);
  const LostSurface lost = box.lost();
  EXPECT_EQ(lost.triangles.staying, box.model.triangles.size());
  EXPECT_EQ(lost.large_share, 0);
  EXPECT_FALSE(lost.warns);
}

}  // namespace
}  // namespace cocoon
