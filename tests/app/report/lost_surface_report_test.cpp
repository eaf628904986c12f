#include "app/report/lost_surface_report.h"

#include <gtest/gtest.h>
#include <string>

#include "tests/mesh_gallery.h"

namespace cocoon::app {
namespace {

bool says(const std::string& message, const std::string& part) {
  return message.find(part) != std::string::npos;
}

TEST(LostSurfaceReport, SaysHowMuchIsLostAndWhatToDo) {
  const TriangleMesh box = gallery::box(10, 10, 10);
  LostSurface lost;
  lost.share = 0.25;
  lost.astray.count = 3;
  lost.astray.largest = TriangleId(0U);
  const std::string where = warning_of_lost_surface(lost, "", "box", box);
  EXPECT_TRUE(says(where, "25 % of the surface of box")) << where;
  EXPECT_TRUE(says(where, "(3 triangles, as at (")) << where;
  lost.is_coarse = true;
  EXPECT_TRUE(says(warning_of_lost_surface(lost, "", "box", box), "--densify SPACING"));
  const std::string tried =
      warning_of_lost_surface(lost, "made dense it keeps no more", "box", box);
  EXPECT_TRUE(says(tried, "its triangles are large, and made dense it keeps no more;")) << tried;
}

TEST(LostSurfaceReport, SaysHowFarSurfaceIsMadeUp) {
  LostSurface lost;
  lost.made_up = {.places = 4, .area = 1, .farthest = {1, 2, 3}, .distance = 3};
  lost.spacing = 0.5;
  const std::string message = warning_of_made_up_surface(lost, "box");
  EXPECT_TRUE(says(message, "up to 3 (6.0 times the spacing) off its surface")) << message;
  EXPECT_TRUE(says(message, "(1, 2, 3)")) << message;
}

TEST(LostSurfaceReport, HasSharesAndDistancesOnlyWhereThereAreAny) {
  LostSurface lost;
  JsonReport none;
  add_lost_surface(none, lost);
  EXPECT_TRUE(says(none.text(), "\"lost_triangles\": 0")) << none.text();
  EXPECT_FALSE(says(none.text(), "astray_area_share"));
  EXPECT_FALSE(says(none.text(), "made_up_distance"));
  lost.share = 0.25;
  lost.made_up = {.places = 4, .area = 1, .farthest = {1, 2, 3}, .distance = 3};
  JsonReport some;
  add_lost_surface(some, lost);
  EXPECT_TRUE(says(some.text(), "\"astray_area_share\": 0.25"));
  EXPECT_TRUE(says(some.text(), "\"made_up_places\": 4"));
  EXPECT_TRUE(says(some.text(), "\"made_up_distance\": 3"));
}

}  // namespace
}  // namespace cocoon::app
