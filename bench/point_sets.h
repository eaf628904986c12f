// The point sets of the benchmarks by their names (README.md), all from fixed seeds.
#pragma once

#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <vector>

#include "geom/random/random.h"
#include "tests/gallery.h"

namespace cocoon::bench {

// Random angles on a torus of radii 1 and 0.35, as exactly as doubles allow: spheres touch the tube
// along whole circles, so three times as many cells as on a scan, with spheres that nearly agree.
inline std::vector<Point> exact_torus(std::size_t count) {
  Random random(1);
  std::vector<Point> points;
  points.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double u = random.uniform(0, 2 * std::numbers::pi);
    const double v = random.uniform(0, 2 * std::numbers::pi);
    const double ring = 1 + 0.35 * std::cos(v);
    points.push_back({ring * std::cos(u), ring * std::sin(u), 0.35 * std::sin(v)});
  }
  return points;
}

// About `count` points; none for a name that does not exist.
inline std::vector<Point> point_set(const std::string& name, std::size_t count) {
  const auto n = static_cast<double>(count);
  if (name == "uniform") return gallery::uniform_cube(count);
  if (name == "torus") return gallery::displaced_torus(count);
  if (name == "bumpy_sphere") return gallery::bumpy_sphere(count);
  if (name == "exact_torus") return exact_torus(count);
  if (name == "grid") return gallery::integer_grid(static_cast<int>(std::lround(std::cbrt(n))));
  if (name == "sphere") return gallery::sphere(count);
  if (name == "box") return gallery::box_faces(static_cast<int>(std::lround(std::sqrt(n / 52))));
  return {};
}

}  // namespace cocoon::bench
