// Updates by scans in rows, as a laser line makes them.
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <vector>

#include "geom/random/random.h"
#include "tests/end_to_end/hill_on_ball.h"
#include "update/update_model.h"

namespace cocoon {
namespace {

using testing::ball_radius;
using testing::hill;
using testing::hill_width;
using testing::scan_reach;

// Around the top of a sphere with a hill or a dent: rows `across` apart, turned by an angle.
std::vector<Point> scan_in_rows(double height, double across, double along, double noise,
                                std::uint64_t seed) {
  Random random(seed);
  const double angle = std::numbers::pi * random.uniform();
  std::vector<Point> cloud;
  for (double row = -scan_reach; row <= scan_reach; row += across) {
    for (double place = -scan_reach + along * random.uniform(); place <= scan_reach;
         place += along * random.uniform(0.7, 1.3)) {
      const double x = std::cos(angle) * row - std::sin(angle) * place;
      const double y = std::sin(angle) * row + std::cos(angle) * place;
      if (std::hypot(x, y) > scan_reach) continue;
      const double z = std::sqrt(ball_radius * ball_radius - x * x - y * y);
      const Vec3 error = noise * random.on_unit_sphere();
      cloud.push_back(Point{x, y, z + height * hill(std::hypot(x, y), hill_width)} + error);
    }
  }
  return cloud;
}

// The model has samples a unit apart; the scans four to ten samples along a row to one across, as
// far apart as those of the model or twice.
TEST(UpdateScanRows, ReplaceWhatIsWrongAndNothingElse) {
  const TriangleMesh model = testing::ball_model();
  std::uint64_t seed = 0;
  for (const double across : {1.0, 1.5, 2.0}) {
    for (const double ratio : {4.0, 7.0, 10.0}) {
      for (const double height : {3.0, -3.0}) {
        const double along = across / ratio;
        const testing::Clouds clouds = {scan_in_rows(height, across, along, 0.1 * along, ++seed)};
        const UpdateResult result = update_model(model, clouds);
        SCOPED_TRACE(::testing::Message() << across << " " << ratio << " " << height);
        testing::expect_new_top(model, clouds, result);
        EXPECT_GT(result.clouds[0].surface.set_aside, clouds[0].size() / 4);
      }
    }
  }
}

}  // namespace
}  // namespace cocoon
