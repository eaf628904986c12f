#include "ref/scan_errors.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "geom/errors.h"
#include "geom/random/random.h"

namespace cocoon {
namespace {

std::vector<Point> some_points() {
  Random random(3);
  std::vector<Point> points;
  for (int k = 0; k < 500; ++k) points.push_back(10 * random.in_unit_cube());
  return points;
}

TEST(ScanErrors, NoiseStaysWithinItsReach) {
  const std::vector<Point> ideal = some_points();
  std::vector<Point> cloud = ideal;
  ref::add_scan_errors(cloud, {.noise = 0.25});
  double farthest = 0;
  for (std::size_t k = 0; k < cloud.size(); ++k) {
    farthest = std::max(farthest, distance(cloud[k], ideal[k]));
  }
  EXPECT_LE(farthest, 0.25);
  EXPECT_GT(farthest, 0.2);
}

TEST(ScanErrors, RegistrationMovesTheCloudAsAWhole) {
  const std::vector<Point> ideal = some_points();
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    std::vector<Point> cloud = ideal;
    ref::add_scan_errors(cloud, {.registration = 0.1, .seed = seed});
    double farthest = 0;
    for (std::size_t k = 0; k < cloud.size(); ++k) {
      farthest = std::max(farthest, distance(cloud[k], ideal[k]));
      // Lengths change in the second order of the turn, about 0.1 / 10.
      EXPECT_NEAR(distance(cloud[k], cloud[0]), distance(ideal[k], ideal[0]), 0.01);
    }
    EXPECT_NEAR(farthest, 0.1, 1e-12);
  }
}

TEST(ScanErrors, NoneChangesNothingAndBadOnesAreRefused) {
  std::vector<Point> cloud = some_points();
  ref::add_scan_errors(cloud, {});
  EXPECT_EQ(cloud, some_points());
  EXPECT_THROW(ref::add_scan_errors(cloud, {.noise = -1}), InputError);
  EXPECT_THROW(ref::add_scan_errors(cloud, {.registration = std::nan("")}), InputError);
  std::vector<Point> none;
  ref::add_scan_errors(none, {.noise = 1, .registration = 1});
  EXPECT_TRUE(none.empty());
}

}  // namespace
}  // namespace cocoon
