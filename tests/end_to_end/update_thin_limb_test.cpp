// Scans all around a limb so thin, or so coarse, that their rims are as small as pin-holes.
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <vector>

#include "cocone/reconstruct.h"
#include "geom/mesh_check.h"
#include "geom/random/random.h"
#include "tests/end_to_end/local_update.h"
#include "tests/update/hand_made_models.h"
#include "update/update_model.h"

namespace cocoon {
namespace {

using std::numbers::pi;
using testing::Clouds;
using testing::expect_local_update;
using testing::hill;

constexpr double tube = 0.2;
constexpr double scan_length = 1.2;  // along the ring, whose radius is 1

double along(const Point& p) { return std::atan2(p.y, p.x); }

TriangleMesh thin_ring() {
  std::vector<Point> points;
  Random random(2);
  for (int i = 0; i < 160; ++i) {
    for (int j = 0; j < 32; ++j) {
      points.push_back(testing::torus_point(2 * pi * (i + 0.3 * random.uniform()) / 160,
                                            2 * pi * (j + 0.3 * random.uniform()) / 32, tube));
    }
  }
  return reconstruct_tight(points).mesh;
}

// Samples all around the tube, which is now thicker in the middle of the scan.
Clouds sleeve(int around, int rows) {
  Clouds clouds(1);
  for (int i = 0; i <= rows; ++i) {
    const double u = scan_length * i / rows;
    const double radius = tube * (1 + 0.2 * hill(std::abs(u - scan_length / 2), 0.5));
    for (int j = 0; j < around; ++j) {
      clouds[0].push_back(testing::torus_point(u, 2 * pi * (j + 0.5 * (i % 2)) / around, radius));
    }
  }
  return clouds;
}

TEST(UpdateThinLimb, ASleeveOfFewSamplesAround) {
  const TriangleMesh model = thin_ring();
  ASSERT_EQ(mesh_check(model).euler, 0);
  for (const int around : {6, 7, 8}) {
    for (const int rows : {8, 10, 12}) {
      const Clouds clouds = sleeve(around, rows);
      const UpdateResult result = update_model(model, clouds);
      expect_local_update(
          model, clouds, result,
          [](const Point& p) { return along(p) > 0.15 && along(p) < scan_length - 0.15; },
          [](const Point& p) { return along(p) < -0.15 || along(p) > scan_length + 0.15; });
      EXPECT_EQ(mesh_check(result.mesh).euler, 0);
      ASSERT_EQ(result.clouds[0].loops.size(), 2U);
      EXPECT_TRUE(result.clouds[0].loops[0].pin_hole && result.clouds[0].loops[1].pin_hole);
      EXPECT_EQ(result.warnings.size(), 2U);
    }
  }
}

// Away from the model its ends are nothing to join it by; nor is one end alone on a ring.
TEST(UpdateThinLimb, ASleeveOffTheModelIsClosed) {
  const TriangleMesh model = thin_ring();
  Clouds far = sleeve(7, 10);
  for (Point& p : far[0]) p = p + Vec3{0, 0, 1};
  EXPECT_EQ(update_model(model, far).status, UpdateStatus::cloud_closed);

  Clouds hinged = sleeve(7, 10);
  for (Point& p : hinged[0]) p.z += 0.5 * along(p) * along(p);
  const UpdateResult result = update_model(model, hinged);
  EXPECT_EQ(result.status, UpdateStatus::cloud_closed) << result.message;
  EXPECT_TRUE(result.mesh.triangles.empty());
}

}  // namespace
}  // namespace cocoon
