// A ball with a handle on top, and scans of its top with a lid on each foot of the handle: the
// handle goes.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "geom/point.h"
#include "geom/random/random.h"
#include "tests/end_to_end/spread_points.h"

namespace cocoon::testing {

constexpr double handle_spacing = 0.05;  // of all samples, roughly

// Of a point above the surface of the handle, a half of a torus.
inline double height_of_handle(const Point& p) {
  const double along = std::hypot(p.x, p.z - 0.95) - 0.45;
  return std::hypot(along, p.y) - 0.15;
}

inline std::vector<Point> ball_with_handle() {
  SpreadPoints points(0.75 * handle_spacing);
  Random random(3);
  for (int k = 0; k < 60000; ++k) {
    const Point p = random.on_unit_sphere();
    if (height_of_handle(p) > 0) points.add(p);
    const double around = 2 * std::numbers::pi * random.uniform();
    const double across = 2 * std::numbers::pi * random.uniform();
    const double radius = 0.45 + 0.15 * std::cos(across);
    const Point q = {radius * std::cos(around), 0.15 * std::sin(across),
                     0.95 + radius * std::sin(around)};
    if (norm(q) > 1) points.add(q);
  }
  return points.points();
}

inline std::vector<Point> top_of_ball(std::uint64_t seed) {
  SpreadPoints points(0.75 * handle_spacing);
  Random random(seed);
  for (int k = 0; k < 60000; ++k) {
    const Point p = random.on_unit_sphere();
    if (p.z > 0.5) points.add(p);
  }
  return points.points();
}

}  // namespace cocoon::testing
