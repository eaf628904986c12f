// An arch is put on a block. Of what is under it, the scan has the arch's own lower side alone: the
// block's top was seen at too flat an angle.
#include <cmath>
#include <cstdint>
#include <gtest/gtest.h>
#include <numbers>
#include <vector>

#include "geom/mesh_check.h"
#include "geom/random/random.h"
#include "tests/end_to_end/local_update.h"
#include "tests/update/hand_made_models.h"
#include "update/update_model.h"

namespace cocoon {
namespace {

constexpr double top = 6;      // of the block, which is 60 wide and 30 deep, vertices 1 apart
constexpr double middle = 30;  // of the arch, half a torus over the line y = 15
constexpr double span = 16;
constexpr double thickness = 4;

double across(const Point& p) { return std::abs(p.y - 15); }
double along(const Point& p) { return std::abs(p.x - middle); }

bool is_in_foot(const Point& p, double radius) {
  return std::hypot(along(p) - span, p.y - 15) < radius;
}
bool is_under_arch(const Point& p, double margin) {
  return p.z == top && across(p) < thickness - margin && along(p) < span - thickness - margin;
}

std::vector<Point> arch(Random& random) {
  const int rings = static_cast<int>(std::numbers::pi * span);
  const int around = static_cast<int>(2 * std::numbers::pi * thickness);
  std::vector<Point> points;
  for (int i = 0; i < rings; ++i) {
    for (int k = 0; k < around; ++k) {
      const double u = (i + 0.5 + random.uniform(-0.2, 0.2)) * std::numbers::pi / rings;
      const double v = (k + random.uniform(-0.2, 0.2)) * 2 * std::numbers::pi / around;
      const double r = span + thickness * std::cos(v);
      points.push_back(
          {middle + r * std::cos(u), 15 + thickness * std::sin(v), top + r * std::sin(u)});
    }
  }
  return points;
}

testing::Clouds scan(std::uint64_t seed) {
  Random random(seed);
  testing::Clouds clouds{arch(random)};
  for (int i = 3; i < 57; ++i) {
    for (int k = 4; k < 26; ++k) {
      const Point p{i + 0.5 + random.uniform(-0.2, 0.2), k + 0.5 + random.uniform(-0.2, 0.2), top};
      if (!is_in_foot(p, thickness) && !is_under_arch(p, 0)) clouds[0].push_back(p);
    }
  }
  return clouds;
}

TEST(UpdateByAnArch, WhatIsUnderItStays) {
  const TriangleMesh model = testing::block(60, 30, 6);
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const testing::Clouds clouds = scan(seed);
    const UpdateResult result = update_model(model, clouds);
    testing::expect_local_update(
        model, clouds, result,
        [](const Point& p) { return p.z == top && is_in_foot(p, thickness - 1.5); },
        [](const Point& p) { return p.z < top || is_under_arch(p, 2); });
    EXPECT_EQ(mesh_check(result.mesh).euler, 0) << seed;
  }
}

}  // namespace
}  // namespace cocoon
