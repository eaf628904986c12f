// A ball, and a scan of a hole drilled through it.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <ostream>
#include <vector>

#include "geom/point.h"
#include "tests/gallery.h"

namespace cocoon::testing {

struct DrilledBall {
  std::size_t samples = 5000;  // of the ball of radius 1
  double offset = 0.2;         // of the hole's axis, which is parallel to z
  double radius = 4;           // of the hole, in spacings of the ball
  double density = 1;          // of the scan, linear, in those of the ball

  double spacing() const { return std::sqrt(4 * std::numbers::pi / static_cast<double>(samples)); }
  double from_axis(const Point& p) const { return std::hypot(p.x - offset, p.y); }
  std::vector<Point> ball() const { return gallery::even_sphere(samples); }

  // The wall in rings, and the ball around both mouths.
  std::vector<Point> scan() const {
    const double hole = radius * spacing();
    const double step = spacing() / density;
    const double reach = hole + 4.5 * std::max(spacing(), step);
    std::vector<Point> points;
    const double count = static_cast<double>(samples) * density * density;
    for (const Point& p : gallery::even_sphere(static_cast<std::size_t>(count))) {
      if (from_axis(p) > hole + 0.5 * step && from_axis(p) < reach) points.push_back(p);
    }
    const auto in_ring = static_cast<int>(2 * std::numbers::pi * hole / step);
    for (int ring = 0; - 1 + 0.87 * step * ring < 1; ++ring) {
      for (int k = 0; k < in_ring; ++k) {
        const double turn = 2 * std::numbers::pi * (k + 0.5 * (ring % 2)) / in_ring;
        const Point p{offset + hole * std::cos(turn), hole * std::sin(turn),
                      -1 + 0.87 * step * ring};
        if (norm(p) < 1 - 0.2 * step) points.push_back(p);
      }
    }
    return points;
  }
};

inline void PrintTo(const DrilledBall& ball, std::ostream* out) {
  *out << ball.samples << " samples, hole at " << ball.offset << " of " << ball.radius
       << " spacings, density " << ball.density;
}

}  // namespace cocoon::testing
