#include "app/report/page_view.h"

#include <cmath>
#include <gtest/gtest.h>
#include <vector>

namespace cocoon::app {
namespace {

using Corners = std::array<Point, 3>;

// A triangle whose front faces the given way.
Corners facing(const Vec3& way) {
  const Vec3 side = cross(way, std::abs(way.z) < 0.5 ? Vec3{0, 0, 1} : Vec3{1, 0, 0});
  const Vec3 other = cross(way, side);
  return {Point{0, 0, 0}, Point{side.x, side.y, side.z}, Point{other.x, other.y, other.z}};
}

TEST(PageView, StaysWhereTheChangeIsSeen) {
  const std::vector<Corners> top = {facing({0, 0, 1})};
  EXPECT_EQ(view_towards(top).azimuth_deg, PageView{}.azimuth_deg);
  EXPECT_EQ(view_towards(top, {.enough = 1}).elevation_deg, 60);
}

TEST(PageView, WithoutAChangeItIsTheDefault) {
  EXPECT_EQ(view_towards({}).azimuth_deg, PageView{}.azimuth_deg);
  EXPECT_EQ(view_towards({}).elevation_deg, PageView{}.elevation_deg);
}

TEST(PageView, TurnsToWhatFacesAway) {
  const PageView below = view_towards(std::vector<Corners>{facing({0, 0, -1})});
  EXPECT_LT(below.elevation_deg, 0);
  // The default looks from (0.44, -0.76, 0.47).
  const PageView behind = view_towards(std::vector<Corners>{facing({-0.5, 0.866, 0})});
  EXPECT_EQ(behind.azimuth_deg, 120);
  EXPECT_EQ(behind.elevation_deg, 0);
}

TEST(PageView, WeighsByArea) {
  Corners large = facing({0, 0, -1});
  for (Point& p : large) p = 3 * p;
  const PageView view = view_towards(std::vector<Corners>{facing({0, 0, 1}), large});
  EXPECT_LT(view.elevation_deg, 0);
}

}  // namespace
}  // namespace cocoon::app
