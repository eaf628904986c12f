// A ball on whose top a scan finds a hill or a dent: what the tests of strange scans update.
#pragma once

#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "cocone/reconstruct.h"
#include "geom/mesh_check.h"
#include "tests/end_to_end/local_update.h"
#include "tests/gallery.h"
#include "update/update_model.h"

namespace cocoon::testing {

constexpr double ball_radius = 20;
constexpr double scan_reach = 9;  // from the axis
constexpr double hill_width = 7;

inline double off_axis(const Point& p) { return std::hypot(p.x, p.y); }

// With samples a unit apart.
inline TriangleMesh ball_model() {
  std::vector<Point> points = gallery::even_sphere(5000);
  for (Point& p : points) p = ball_radius * p;
  return reconstruct_tight(points).mesh;
}

// The ball is whole, its top is as the scans have it, and nothing else went.
inline void expect_new_top(const TriangleMesh& model, const Clouds& clouds,
                           const UpdateResult& result) {
  expect_local_update(
      model, clouds, result, [](const Point& p) { return p.z > 0 && off_axis(p) < 6; },
      [](const Point& p) { return p.z < 0 || off_axis(p) > scan_reach + 1; });
  EXPECT_EQ(mesh_check(result.mesh).euler, 2);
}

}  // namespace cocoon::testing
