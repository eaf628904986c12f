#include "update/checks/rim_shift.h"

#include <gtest/gtest.h>

#include "geom/random/random.h"
#include "tests/update/hand_made_models.h"

namespace cocoon {
namespace {

using testing::circle;
using testing::rim_of;

double shift_of(const TriangleMesh& mesh, const CloudRim& rim) {
  const ModelIndex model(mesh);
  return norm(rim_shift(model, rim, overlapping_facets(model, rim)));
}

// Moved along the surface, the rim of a cap still lies on the sphere nearly all around.
TEST(RimShift, TellsACloudMovedAlongTheSurface) {
  const TriangleMesh ball = testing::sphere(5);
  for (const double moved : {0.0, 0.02, 0.06}) {
    RimLoop loop = testing::cap_rim(120, {0, 0, 1}, 0.8);
    for (Point& p : loop.points) p = p + moved * Vec3{1, 0, 0};
    CloudRim rim = rim_of({loop});
    rim.spacing = 0.04;
    const ModelIndex model(ball);
    const Vec3 shift = rim_shift(model, rim, overlapping_facets(model, rim));
    EXPECT_LT(distance(shift, {moved, 0, 0}), 0.1 * moved + 0.002);
  }
}

TEST(RimShift, TellsACloudMovedOffTheSurface) {
  const CloudRim rim = rim_of({circle(40, {10, 10, 0.6}, 6)});
  EXPECT_NEAR(shift_of(testing::grid_plane(20), rim), 0.6, 0.02);
}

// However far it is: what lies off is left out from the second round on. And a number of spacings
// that the prior makes a little smaller, whatever the number of points.
TEST(RimShift, TellsACloudMovedBySpacings) {
  for (const std::size_t points : {40U, 80U}) {
    CloudRim rim = rim_of({circle(points, {10, 10, 1.5}, 6)});
    rim.spacing = 0.25;
    EXPECT_NEAR(shift_of(testing::grid_plane(20), rim), 1.5 / 1.02, 1e-9);
  }
}

// Nothing tells along a plane; few points tell nothing.
TEST(RimShift, IsZeroWhereNothingTells) {
  EXPECT_NEAR(shift_of(testing::grid_plane(20), rim_of({circle(40, {10, 10, 0}, 6)})), 0, 1e-12);
  EXPECT_EQ(shift_of(testing::grid_plane(20), rim_of({circle(11, {10, 10, 0.6}, 6)})), 0);
}

// Where the rim leaves the model, as in the shadow of a boss, its points are of the change.
TEST(RimShift, LeavesOutWhatIsOfTheChange) {
  RimLoop loop = circle(60, {10, 10, 0.1}, 6);
  for (std::size_t i = 0; i < 12; ++i) loop.points[i].z = 2.5;
  CloudRim rim = rim_of({loop});
  rim.spacing = 0.6;
  EXPECT_NEAR(shift_of(testing::grid_plane(20), rim), 0.1, 0.01);
}

// Points that are not looked for, loops that are holes, and half of all at odds with the others.
TEST(RimShift, CountsThePointsOfTheRimAlone) {
  const TriangleMesh mesh = testing::grid_plane(20);
  const ModelIndex model(mesh);
  CloudRim rim = rim_of({circle(12, {10, 10, 0.6}, 6), circle(40, {10, 10, 2}, 3)});
  Overlap overlap = overlapping_facets(model, rim);
  overlap.loops[1].match = LoopMatch::off_model;
  EXPECT_LT(distance(rim_shift(model, rim, overlap), {0, 0, 0.6}), 0.02);
  rim.loops[0].inner.assign(12, 0);
  rim.loops[0].inner[3] = rim.loops[0].inner[4] = 1;  // one point between them
  EXPECT_EQ(rim_shift(model, rim, overlap), Vec3()) << "eleven are left";
}

TEST(RimShift, IsZeroIfMostPointsDisagree) {
  const TriangleMesh mesh = testing::grid_plane(20);
  RimLoop loop = circle(60, {10, 10, 0}, 6);
  const double heights[] = {1.5, -1.5, 0.3, 1.5, -1.5};
  for (std::size_t i = 0; i < loop.size(); ++i) loop.points[i].z = heights[i % 5];
  const ModelIndex model(mesh);
  CloudRim rim = rim_of({loop});
  const Overlap overlap = overlapping_facets(model, rim);
  rim.spacing = 1;
  EXPECT_EQ(rim_shift(model, rim, overlap), Vec3());
  EXPECT_LT(distance(rim_shift(model, rim, overlap, {.min_share = 0}), {0, 0, 0.3}), 0.02);
}

// A scan that ends on the top of a boss, all around: only its samples on the model tell that it is
// not out of register.
TEST(CloudShift, IsZeroIfMoreSamplesLieOnTheModelAsTheyAre) {
  const TriangleMesh mesh = testing::grid_plane(20);
  const ModelIndex model(mesh);
  const CloudRim rim = rim_of({circle(40, {10, 10, 1.5}, 6)});
  const Overlap overlap = overlapping_facets(model, rim);
  std::vector<Point> samples;
  for (int k = 0; k < 30; ++k) samples.push_back({5 + 0.3 * k, 9, k < 16 ? 0.0 : 1.5});
  EXPECT_NEAR(norm(rim_shift(model, rim, overlap)), 1.5, 0.05);
  EXPECT_EQ(cloud_shift(model, samples, rim, overlap), Vec3());
  for (Point& p : samples) p.z = 1.5 - p.z;
  EXPECT_EQ(cloud_shift(model, samples, rim, overlap), rim_shift(model, rim, overlap));
}

// Nothing is asked of samples if the shift is short.
TEST(CloudShift, IsThatOfTheRimIfItIsShort) {
  const TriangleMesh mesh = testing::grid_plane(20);
  const ModelIndex model(mesh);
  const CloudRim rim = rim_of({circle(40, {10, 10, 0.6}, 6)});
  const Overlap overlap = overlapping_facets(model, rim);
  const std::vector<Point> samples = {{9, 9, 0}, {10, 9, 0}, {11, 9, 0}};
  EXPECT_EQ(cloud_shift(model, samples, rim, overlap), rim_shift(model, rim, overlap));
}

}  // namespace
}  // namespace cocoon
