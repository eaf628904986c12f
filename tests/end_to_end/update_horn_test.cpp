// A scan that ends below the tip of a horn beside what has changed.
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "cocone/reconstruct.h"
#include "geom/mesh_check.h"
#include "tests/end_to_end/local_update.h"
#include "update/update_model.h"

namespace cocoon {
namespace {

using testing::Clouds;
using testing::hill;
using testing::polar_angle;
using testing::sphere_points;

// A sphere with a thin horn in this direction, and the polar angle of its scan about the hill.
constexpr double horn_height = 0.5;
constexpr double scan_angle = 0.7;

double horned_radius(const Point& p) {
  const double angle = polar_angle(p, unit(Vec3{std::sin(0.5), 0, std::cos(0.5)}));
  return 1 + horn_height * std::exp(-angle * angle / 0.01);
}

// Ten times as dense where the horn is steep.
std::vector<Point> horned_sphere(std::uint64_t seed) {
  std::vector<Point> points;
  for (const bool at_horn : {false, true}) {
    for (const Point& p : sphere_points(at_horn ? 30000 : 3000, seed)) {
      const double radius = horned_radius(p);
      if (at_horn == (radius > 1.005)) points.push_back(radius * p);
    }
  }
  return points;
}

// A scan of a hill of this height beside the horn ends below its tip: a small hole in it.
Clouds scan_beside_horn(double height) {
  Clouds clouds(1);
  for (const Point& p : horned_sphere(7)) {
    const double angle = polar_angle(p, {0, 0, 1});
    if (angle > scan_angle || norm(p) > 1.3) continue;
    clouds[0].push_back((1 + height * hill(angle, 0.3)) * p);
  }
  return clouds;
}

// Vertices of the horn beyond that radius that went.
std::size_t lost_beyond(double radius, const TriangleMesh& model, const UpdateResult& result) {
  std::size_t lost = 0;
  for (const VertexId v : model.points.ids()) {
    lost += norm(model.points[v]) > radius && result.vertex_map[v].is_none() ? 1U : 0U;
  }
  return lost;
}

TEST(UpdateBesideAHorn, WhatSticksOutOfTheScanStays) {
  const TriangleMesh model = reconstruct_tight(horned_sphere(1)).mesh;
  ASSERT_EQ(mesh_check(model).euler, 2);
  const Clouds clouds = scan_beside_horn(0.2);
  const UpdateResult result = update_model(model, clouds);
  ASSERT_EQ(result.status, UpdateStatus::ok) << result.message;
  EXPECT_EQ(lost_beyond(1.34, model, result), 0U);
  EXPECT_EQ(mesh_check(result.mesh).euler, 2);
  ASSERT_EQ(result.clouds[0].loops.size(), 2U);
  EXPECT_TRUE(result.clouds[0].loops[1].pin_hole);

  UpdateOptions leave;
  leave.pin_holes.max_distance = 0;
  leave.cut.ends.scanned = 1e9;
  EXPECT_GT(lost_beyond(1.34, model, update_model(model, clouds, leave)), 10U);
}

// Beside a dent, so that the horn sticks out of the box of the samples, too. Where the
// hole is taken for no rim, the samples tell that the scan ends there.
TEST(UpdateBesideAHorn, ItStaysBesideADentThoughNoRimIsThere) {
  const TriangleMesh model = reconstruct_tight(horned_sphere(1)).mesh;
  UpdateOptions options;
  options.pin_holes.max_distance = 0;
  const UpdateResult result = update_model(model, scan_beside_horn(-0.2), options);
  ASSERT_EQ(result.status, UpdateStatus::ok) << result.message;
  EXPECT_EQ(result.clouds[0].loops.size(), 1U);
  EXPECT_GT(result.clouds[0].cut.scan_ends, 0U);
  // But for what is less than two spacings beyond its end.
  EXPECT_EQ(lost_beyond(1.45, model, result), 0U);
}

// Half a spacing out of register all samples seem to be of a change, unless the shift is known.
TEST(UpdateBesideAHorn, ItStaysThoughTheScanIsOutOfRegister) {
  const TriangleMesh model = reconstruct_tight(horned_sphere(1)).mesh;
  Clouds clouds = scan_beside_horn(-0.2);
  for (Point& p : clouds[0]) p = p + 0.04 * Vec3{std::cos(0.5), 0, -std::sin(0.5)};
  UpdateOptions options;
  options.pin_holes.max_distance = 0;
  const UpdateResult result = update_model(model, clouds, options);
  ASSERT_EQ(result.status, UpdateStatus::ok) << result.message;
  EXPECT_NEAR(result.clouds[0].shift, 0.04, 0.01);
  EXPECT_GT(result.clouds[0].cut.scan_ends, 0U);
  EXPECT_EQ(lost_beyond(1.45, model, result), 0U);

  options.shift.max_shift = 0;
  const UpdateResult unaware = update_model(model, clouds, options);
  ASSERT_EQ(unaware.status, UpdateStatus::ok) << unaware.message;
  EXPECT_GT(lost_beyond(1.45, model, unaware), 5U);
}

}  // namespace
}  // namespace cocoon
