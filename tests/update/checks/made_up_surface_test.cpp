#include "update/checks/made_up_surface.h"

#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "geom/errors.h"
#include "tests/update/hand_made_models.h"

namespace cocoon {
namespace {

// A plane of unit squares, and a triangle over it, at this height.
class RoofOverAPlane : public ::testing::Test {
 protected:
  RoofOverAPlane() : plane_(testing::grid_plane(20)), updated_(plane_) {}

  MadeUpSurface under_roof(double height, const std::vector<Point>& samples,
                           const MadeUpOptions& options = {}, const AstrayOptions& of_places = {}) {
    Triangle roof;
    const std::vector<Point> corners = {{9, 9, height}, {10, 9, height}, {9, 10, height}};
    for (std::size_t i = 0; i < 3; ++i) roof.at(i) = updated_.points.push_back(corners[i]);
    const std::vector<TriangleId> added = {updated_.triangles.push_back(roof)};
    const Scan scans[] = {{samples, 1}};
    return made_up_surface(plane_, updated_, added, UnscannedPlaces(scans, of_places), options);
  }

  const std::vector<Point> far_away_ = {{0, 0, 0}};

 private:
  TriangleMesh plane_;
  TriangleMesh updated_;
};

TEST_F(RoofOverAPlane, IsMadeUpWhereNothingWasScanned) {
  const MadeUpSurface made_up = under_roof(2.5, far_away_);
  EXPECT_EQ(made_up.places, 1U);
  EXPECT_DOUBLE_EQ(made_up.area, 0.5);
  EXPECT_DOUBLE_EQ(made_up.distance, 2.5);
  EXPECT_EQ(made_up.farthest.z, 2.5);
}

TEST_F(RoofOverAPlane, IsNotIfItIsNearTheModelOrASample) {
  EXPECT_EQ(under_roof(0.9, far_away_).places, 0U);
  EXPECT_EQ(under_roof(0.9, far_away_, {.distance = 0.5}).places, 1U);
  EXPECT_EQ(under_roof(2.5, {{9, 9, 4}}).places, 0U);
  AstrayOptions near;
  near.reach = 1;
  EXPECT_EQ(under_roof(2.5, {{9, 9, 4}}, {}, near).places, 1U);
}

TEST_F(RoofOverAPlane, OptionsOutOfRangeAreRefused) {
  EXPECT_THROW(under_roof(2.5, far_away_, {.distance = -1}), InputError);
  AstrayOptions wrong;
  wrong.reach = std::nan("");
  EXPECT_THROW(under_roof(2.5, far_away_, {}, wrong), InputError);
}

}  // namespace
}  // namespace cocoon
