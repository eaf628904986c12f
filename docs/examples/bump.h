// What the examples scan: a ball, parts of it, and a bump on it.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "geom/point.h"

// Evenly spread over the unit sphere, up to `reach` radians from the pole on the side of `pole`;
// within 0.6 radians moved outward to a bump of height `bump`.
inline std::vector<cocoon::Point> cap(int n, double reach, double bump, double pole = 1) {
  std::vector<cocoon::Point> points;
  for (int i = 0; i < n; ++i) {
    const double z = 1 - (2.0 * i + 1) / n;
    const double latitude = std::acos(z);
    if (latitude > reach) break;
    const double angle = std::numbers::pi * (3 - std::sqrt(5.0)) * i;
    const double r = std::sqrt(1 - z * z);
    const double rise = std::min(1.0, latitude / 0.6) * std::numbers::pi;
    const double height = 1 + bump * (std::cos(rise) + 1) / 2;
    points.push_back(height * cocoon::Vec3{r * std::cos(angle), r * std::sin(angle), pole * z});
  }
  return points;
}
