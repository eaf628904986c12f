#include "update/pin_holes.h"

#include <gtest/gtest.h>
#include <map>
#include <vector>

#include "tests/update/hand_made_models.h"

namespace cocoon {
namespace {

constexpr std::size_t side = 12;

bool in_hole(const Point& p) { return 5 < p.x && p.x < 7 && 5 < p.y && p.y < 7; }

// The unit grid of a square with a square hole of eight edges in its middle.
TriangleMesh plane_with_hole() { return testing::with_hole(testing::grid_plane(side), 5, 7); }

// The plane, and what of a column stands out of the hole.
TriangleMesh plane_with_column(std::size_t height) {
  TriangleMesh mesh = plane_with_hole();
  const TriangleMesh column = testing::block(2, 2, height);
  const auto moved = [&](VertexId v) { return column.points[v] + Vec3{5, 5, 0}; };
  std::map<Point, VertexId> ids;
  for (const VertexId v : mesh.points.ids()) ids.emplace(mesh.points[v], v);
  for (const Triangle& t : column.triangles) {
    if (column.points[t[0]].z + column.points[t[1]].z + column.points[t[2]].z == 0) continue;
    Triangle corners = t;
    for (VertexId& v : corners) {
      const auto [entry, is_new] = ids.try_emplace(moved(v));
      if (is_new) entry->second = mesh.points.push_back(moved(v));
      v = entry->second;
    }
    mesh.triangles.push_back(corners);
  }
  return mesh;
}

// What was scanned: all of the plane, and nothing in the hole.
struct Scan {
  CloudRim rim = cloud_rim(plane_with_hole());
  std::vector<Point> cloud;

  Scan() {
    for (const Point& p : plane_with_hole().points) {
      if (!in_hole(p)) cloud.push_back(p);
    }
  }
  std::size_t opened(const TriangleMesh& model, const PinHoleOptions& options = {}) const {
    return open_pin_holes(ModelIndex(model), cloud, rim, options).size();
  }
};

TEST(PinHoles, AreRimsWhereTheModelGoesOn) {
  const Scan scan;
  ASSERT_EQ(scan.rim.pin_hole_loops.size(), 1U);
  const TriangleMesh model = plane_with_column(4);
  const std::vector<RimLoop> loops = open_pin_holes(ModelIndex(model), scan.cloud, scan.rim);
  ASSERT_EQ(loops.size(), 1U);
  EXPECT_EQ(loops[0].points, scan.rim.pin_hole_loops[0].points);
}

TEST(PinHoles, StayPinHolesWhereTheModelIsFlat) {
  const Scan scan;
  EXPECT_EQ(scan.opened(testing::grid_plane(side)), 0U);
  EXPECT_EQ(scan.opened(plane_with_column(1)), 0U);  // a stump, within the reach of the samples
}

TEST(PinHoles, StayPinHolesAwayFromTheModel) {
  const Scan scan;
  TriangleMesh model = plane_with_column(4);
  for (Point& p : model.points) p = p + Vec3{0, 0, 1.1};
  EXPECT_EQ(scan.opened(model), 0U);
  EXPECT_EQ(scan.opened(model, {.max_distance = 1.2}), 1U);
}

// A hole of perimeter 4 looks no farther than 4 around its middle, in no direction: in the corner
// of a box of that size there is another part of the model.
TEST(PinHoles, LookNoFartherThanTheirPerimeter) {
  Scan scan;
  for (Point& p : scan.cloud) p = 0.5 * p;
  TriangleMesh surface = plane_with_hole();
  for (Point& p : surface.points) p = 0.5 * p;
  scan.rim = cloud_rim(surface);
  ASSERT_EQ(scan.rim.pin_hole_loops.size(), 1U);
  EXPECT_EQ(scan.rim.pin_hole_loops[0].perimeter, 4);
  for (const double off : {2.0, 2.6}) {
    TriangleMesh model = testing::grid_plane(side);
    for (Point& p : model.points) p = 0.5 * p;
    for (const Vec3& by : {Vec3{0, 0, 0}, Vec3{0.2, 0, 0}, Vec3{0, 0.2, 0}}) {
      model.points.push_back(Point{3, 3, 0} + Vec3{off, off, off} + by);
    }
    const std::size_t last = model.points.size() - 1;
    EXPECT_EQ(scan.opened(model), 0U);  // points that no triangle uses are none of the model
    model.triangles.push_back({VertexId(last - 2), VertexId(last - 1), VertexId(last)});
    EXPECT_EQ(scan.opened(model), off == 2 ? 1U : 0U) << off;
  }
}

TEST(PinHoles, CanBeLeftAlone) {
  EXPECT_EQ(Scan().opened(plane_with_column(4), {.max_distance = 0}), 0U);
}

}  // namespace
}  // namespace cocoon
