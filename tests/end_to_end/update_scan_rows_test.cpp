// Updates by scans in rows, as a laser line makes them.
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <vector>

#include "cocone/reconstruct.h"
#include "geom/mesh_check.h"
#include "geom/random.h"
#include "tests/end_to_end/local_update.h"
#include "tests/gallery.h"
#include "update/update_model.h"

namespace cocoon {
namespace {

using testing::expect_local_update;
using testing::hill;

constexpr double radius = 20;
constexpr double reach = 9;  // of the scan, from the axis

double off_axis(const Point& p) { return std::hypot(p.x, p.y); }

// Around the top of a sphere with a hill or a dent: rows `across` apart, turned by an angle.
std::vector<Point> scan_in_rows(double height, double across, double along, double noise,
                                std::uint64_t seed) {
  Random random(seed);
  const double angle = std::numbers::pi * random.uniform();
  std::vector<Point> cloud;
  for (double row = -reach; row <= reach; row += across) {
    for (double place = -reach + along * random.uniform(); place <= reach;
         place += along * random.uniform(0.7, 1.3)) {
      const double x = std::cos(angle) * row - std::sin(angle) * place;
      const double y = std::sin(angle) * row + std::cos(angle) * place;
      if (std::hypot(x, y) > reach) continue;
      const double z = std::sqrt(radius * radius - x * x - y * y);
      const Vec3 error = noise * random.on_unit_sphere();
      cloud.push_back(Point{x, y, z + height * hill(std::hypot(x, y), 7)} + error);
    }
  }
  return cloud;
}

// The model has samples a unit apart; the scans four to ten samples along a row to one across, as
// far apart as those of the model or twice.
TEST(UpdateScanRows, ReplaceWhatIsWrongAndNothingElse) {
  std::vector<Point> points = gallery::even_sphere(5000);
  for (Point& p : points) p = radius * p;
  const TriangleMesh model = reconstruct_tight(points).mesh;
  std::uint64_t seed = 0;
  for (const double across : {1.0, 1.5, 2.0}) {
    for (const double ratio : {4.0, 7.0, 10.0}) {
      for (const double height : {3.0, -3.0}) {
        const double along = across / ratio;
        const testing::Clouds clouds = {scan_in_rows(height, across, along, 0.1 * along, ++seed)};
        const UpdateResult result = update_model(model, clouds);
        expect_local_update(
            model, clouds, result, [](const Point& p) { return p.z > 0 && off_axis(p) < 6; },
            [](const Point& p) { return p.z < 0 || off_axis(p) > reach + 1; });
        EXPECT_EQ(mesh_check(result.mesh).euler, 2) << across << " " << ratio << " " << height;
        EXPECT_GT(result.clouds[0].surface.set_aside, clouds[0].size() / 4);
      }
    }
  }
}

}  // namespace
}  // namespace cocoon
