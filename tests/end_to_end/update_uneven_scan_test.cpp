// Updates by scans that are much denser in some places than in others.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "geom/search/thin_points.h"
#include "tests/end_to_end/hill_on_ball.h"
#include "tests/gallery.h"
#include "update/update_model.h"

namespace cocoon {
namespace {

using testing::ball_radius;
using testing::hill;
using testing::hill_width;
using testing::off_axis;
using testing::scan_reach;

enum class DenseAt { one_side, middle, rim };

// From 0 where samples are to be dense to 1 where they are to be sparse.
double sparseness(DenseAt where, const Point& p) {
  const double way = off_axis(p) / scan_reach;
  return where == DenseAt::one_side ? 0.5 + 0.5 * p.x / scan_reach
         : where == DenseAt::middle ? way
                                    : 1 - way;
}

// Around the top of a sphere with a hill or a dent: samples 0.25 apart here, 2 there.
std::vector<Point> uneven_scan(double height, DenseAt where) {
  std::vector<Point> cap = gallery::even_sphere(300000);
  for (Point& p : cap) p = ball_radius * p;
  std::erase_if(cap, [](const Point& p) { return p.z < 0 || off_axis(p) > scan_reach; });
  const std::vector<PointId> kept = thin_points(cap, [&](PointId k) {
    const double distance = 0.25 * std::pow(8, sparseness(where, cap[k.index()]));
    return distance * distance;
  });
  std::vector<Point> scan;
  for (const PointId k : kept) {
    const Point& p = cap[k.index()];
    scan.push_back(p + Vec3{0, 0, height * hill(off_axis(p), hill_width)});
  }
  return scan;
}

TEST(UpdateUnevenScan, ReplacesWhatIsWrongAndNothingElseWithoutAWarning) {
  const TriangleMesh model = testing::ball_model();
  int looked_at_few = 0;
  for (const DenseAt where : {DenseAt::one_side, DenseAt::middle, DenseAt::rim}) {
    for (const double height : {4.0, -4.0}) {
      const testing::Clouds clouds = {uneven_scan(height, where)};
      const UpdateResult result = update_model(model, clouds);
      testing::expect_new_top(model, clouds, result);
      EXPECT_TRUE(result.warnings.empty()) << result.warnings.front();
      const CloudSurface& surface = result.clouds[0].surface;
      looked_at_few += surface.set_aside > clouds[0].size() / 4 ? 1 : 0;
      EXPECT_TRUE(surface.spacing.is_uneven(DensityOptions{}.min_ratio));
      // All samples come into the model.
      EXPECT_EQ(result.reconstruction.unused_points, 0U);
      EXPECT_GE(result.mesh.points.size(), clouds[0].size() + 4000);
    }
  }
  EXPECT_GE(looked_at_few, 4);
}

}  // namespace
}  // namespace cocoon
