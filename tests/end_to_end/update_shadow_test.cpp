// A boss is put on a block and scanned from one side. In its shadow neither its wall nor its foot
// was seen, so a piece of the rim runs over the top of the boss, or is missing.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <gtest/gtest.h>
#include <numbers>
#include <string>
#include <vector>

#include "geom/mesh_check.h"
#include "geom/random/random.h"
#include "tests/end_to_end/local_update.h"
#include "tests/update/hand_made_models.h"
#include "update/update_model.h"

namespace cocoon {
namespace {

constexpr double top = 8;  // of the block, which is 20 wide and deep, vertices 1 apart
const Point center = {10, 10, top};
constexpr double radius = 4;
constexpr double apart = 0.7;

double from_axis(const Point& p) { return std::hypot(p.x - center.x, p.y - center.y); }

struct Scene {
  double shadow = 1.2;  // reaches this angle to both sides
  double height = 4;    // of the boss
  double reach = 7.5;   // around its axis
  double noise = 0;
};

testing::Clouds scan(const Scene& scene) {
  Random random(2);
  testing::Clouds clouds(1);
  for (double x = 2; x < 18; x += apart) {
    for (double y = 2; y < 18; y += apart) {
      Point p{x + random.uniform(-0.15, 0.15), y + random.uniform(-0.15, 0.15), top};
      const bool is_lit = std::abs(std::atan2(p.y - center.y, p.x - center.x)) >= scene.shadow;
      if (from_axis(p) < radius) {
        p.z += scene.height;
        clouds[0].push_back(p);
      } else if (from_axis(p) < scene.reach && is_lit) {
        clouds[0].push_back(p);
      }
    }
  }
  for (double z = apart / 2; z < scene.height; z += apart) {
    for (double angle = scene.shadow; angle < 2 * std::numbers::pi - scene.shadow;
         angle += apart / radius) {
      clouds[0].push_back(center + Vec3{radius * std::cos(angle), radius * std::sin(angle), z});
    }
  }
  for (Point& p : clouds[0]) {
    if (scene.noise == 0) break;
    for (double* x : {&p.x, &p.y, &p.z}) *x += random.uniform(-scene.noise, scene.noise);
  }
  return clouds;
}

TEST(UpdateInAShadow, TheFootOfABossGoes) {
  const TriangleMesh model = testing::block(20, 20, 8);
  const auto is_foot = [](const Point& p) { return p.z == top && from_axis(p) < radius - 0.8; };
  for (const double shadow : {1.2, 1.6}) {
    SCOPED_TRACE(shadow);
    const testing::Clouds clouds = scan({.shadow = shadow});
    const UpdateResult result = update_model(model, clouds);
    testing::expect_local_update(model, clouds, result, is_foot,
                                 [](const Point& p) { return p.z < top || from_axis(p) > 7.9; });
    EXPECT_EQ(mesh_check(result.mesh).euler, 2);
    EXPECT_GT(result.clouds[0].cut.said_under.size(), 20U);

    UpdateOptions by_rims;
    by_rims.cut.disproved.off_model = 1e9;
    const UpdateResult without = update_model(model, clouds, by_rims);
    EXPECT_GT(std::count_if(without.mesh.points.begin(), without.mesh.points.end(), is_foot), 5);
  }
}

// So is that of a tall one, of which more is in the shadow than a rim may leave out elsewhere.
TEST(UpdateInAShadow, TheRimMayClimbATallBoss) {
  const TriangleMesh model = testing::block(20, 20, 8);
  for (const double height : {4.0, 6.0}) {
    SCOPED_TRACE(height);
    const testing::Clouds clouds =
        scan({.shadow = 1.2, .height = height, .reach = 5.5, .noise = 0.1});
    UpdateOptions whole_rims;
    whole_rims.shadow.max_unmatched_share = 0;
    EXPECT_EQ(update_model(model, clouds, whole_rims).status, UpdateStatus::no_overlap);

    const UpdateResult result = update_model(model, clouds);
    testing::expect_local_update(
        model, clouds, result,
        [](const Point& p) { return p.z == top && from_axis(p) < radius - 1.5; },
        [](const Point& p) { return p.z < top || from_axis(p) > 6; });
    EXPECT_EQ(mesh_check(result.mesh).euler, 2);
    EXPECT_TRUE(result.clouds[0].overlap.in_shadow);
    EXPECT_TRUE(std::any_of(result.warnings.begin(), result.warnings.end(), [](const auto& line) {
      return line.find(
                 "points of its longest loop, by more than 3 spacings: the scan ends on what has "
                 "changed") != line.npos;
    }));
  }
}

// Two scans of it over each other are not one rim in doubt as long as each may have one of its own.
TEST(UpdateInAShadow, JoinedCloudsAreTakenByThemselvesRather) {
  const TriangleMesh model = testing::block(20, 20, 8);
  testing::Clouds clouds = scan({.shadow = 1.2, .height = 6, .reach = 5.5, .noise = 0.1});
  clouds.push_back(clouds[0]);
  Random random(7);
  for (Point& p : clouds[1]) p.x += random.uniform(-0.1, 0.1);
  const UpdateResult result = update_model(model, clouds);
  ASSERT_FALSE(result.warnings.empty());
  EXPECT_NE(result.warnings[0].find("do not make one surface"), std::string::npos)
      << result.warnings[0];
  EXPECT_FALSE(result.clouds[1].joined_with);
}

}  // namespace
}  // namespace cocoon
