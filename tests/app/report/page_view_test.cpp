#include "app/report/page_view.h"

#include <cmath>
#include <gtest/gtest.h>
#include <vector>

namespace cocoon::app {
namespace {

// Adds a triangle around `middle` whose front faces the given way, about as large as that is long.
TriangleId add_facing(TriangleMesh& mesh, const Vec3& way, const Point& middle = {}) {
  const Vec3 side = cross(std::abs(way.z) < 0.5 * norm(way) ? Vec3{0, 0, 1} : Vec3{1, 0, 0}, way);
  const Vec3 other = cross((1 / norm(way)) * way, side);
  const Point corner = middle - (1.0 / 3) * (side + other);
  const VertexId a = mesh.points.push_back(corner);
  const VertexId b = mesh.points.push_back(corner + side);
  const VertexId c = mesh.points.push_back(corner + other);
  return mesh.triangles.push_back({a, b, c});
}

PageView view_of_facing(const std::vector<Vec3>& ways, const PageViewOptions& options = {}) {
  TriangleMesh mesh;
  std::vector<TriangleId> triangles;
  for (const Vec3& way : ways) {
    triangles.push_back(
        add_facing(mesh, way, {10.0 * static_cast<double>(triangles.size()), 0, 0}));
  }
  return view_towards(mesh, triangles, options);
}

TEST(PageView, StaysWhereTheChangeIsSeen) {
  EXPECT_EQ(view_of_facing({{0, 0, 1}}).azimuth_deg, PageView{}.azimuth_deg);
  EXPECT_EQ(view_of_facing({{0, 0, 1}}, {.enough = 1}).elevation_deg, 60);
}

TEST(PageView, WithoutAChangeItIsTheDefault) {
  EXPECT_EQ(view_of_facing({}).azimuth_deg, PageView{}.azimuth_deg);
  EXPECT_EQ(view_of_facing({}).elevation_deg, PageView{}.elevation_deg);
}

TEST(PageView, TurnsToWhatFacesAway) {
  EXPECT_LT(view_of_facing({{0, 0, -1}}).elevation_deg, 0);
  // The default looks from (0.44, -0.76, 0.47).
  const PageView behind = view_of_facing({{-0.5, 0.866, 0}});
  EXPECT_EQ(behind.azimuth_deg, 120);
  EXPECT_EQ(behind.elevation_deg, 0);
}

TEST(PageView, WeighsByArea) {
  EXPECT_LT(view_of_facing({{0, 0, 1}, {0, 0, -3}}).elevation_deg, 0);
}

TEST(PageView, OfManyTrianglesSomeStandForAll) {
  std::vector<Vec3> ways(50, Vec3{0, 0, 1});
  ways.resize(500, Vec3{0, 0, -1});
  EXPECT_LT(view_of_facing(ways, {.asked = 20}).elevation_deg, 0);
}

TEST(PageView, TurnsWhereNothingLiesBeforeTheChange) {
  TriangleMesh mesh;
  const std::vector<TriangleId> change = {add_facing(mesh, {0, 0, 1})};
  const auto stays = [&] {
    const PageView view = view_towards(mesh, change, {.enough = 0.5});
    return view.azimuth_deg == PageView{}.azimuth_deg &&
           view.elevation_deg == PageView{}.elevation_deg;
  };
  EXPECT_TRUE(stays());
  const Vec3 default_direction = {0.44, -0.76, 0.47};
  add_facing(mesh, 0.5 * default_direction, -1 * default_direction);
  EXPECT_TRUE(stays());
  add_facing(mesh, 0.5 * default_direction, default_direction);
  EXPECT_FALSE(stays());
}

}  // namespace
}  // namespace cocoon::app
