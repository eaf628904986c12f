// Small point clouds as text files, for tests that run the program.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <numbers>
#include <sstream>
#include <string>

namespace cocoon::test {

inline std::string point_line(double x, double y, double z) {
  char text[96];
  std::snprintf(text, sizeof text, "%.17g %.17g %.17g\n", x, y, z);
  return text;
}

// Points spread evenly over the part of the unit sphere within `reach` radians of the north pole,
// out of n over the whole sphere (golden spiral). Within 0.6 radians of the pole they are moved
// outward to a bump of this height.
inline std::string sphere_cap(std::size_t n, double reach, double bump = 0) {
  std::string text;
  const double turn = std::numbers::pi * (3 - std::sqrt(5.0));
  for (std::size_t i = 0; i < n; ++i) {
    const double z = 1 - (2 * static_cast<double>(i) + 1) / static_cast<double>(n);
    const double latitude = std::acos(z);
    if (latitude > reach) break;
    const double r = std::sqrt(1 - z * z);
    const double angle = turn * static_cast<double>(i);
    const double rise = std::min(1.0, latitude / 0.6) * std::numbers::pi;
    const double height = 1 + bump * (std::cos(rise) + 1) / 2;
    text += point_line(height * r * std::cos(angle), height * r * std::sin(angle), height * z);
  }
  return text;
}

inline std::string whole_sphere(std::size_t n) { return sphere_cap(n, 4); }

// The same where floats are half a unit apart.
inline std::string far_from_origin(const std::string& points) {
  std::string text;
  std::istringstream rows(points);
  for (double x = 0, y = 0, z = 0; rows >> x >> y >> z;) text += point_line(x + 5e6, y + 5e6, z);
  return text;
}

// 18 points of a sphere of radius 0.1 around (4, 0, 0): a small part beside the unit sphere.
inline std::string crumb() {
  std::string text;
  for (int i = 0; i < 18; ++i) {
    const double z = 1 - (i + 0.5) / 9;
    const double ring = 0.1 * std::sqrt(1 - z * z);
    text += point_line(4 + ring * std::cos(2.4 * i), ring * std::sin(2.4 * i), 0.1 * z);
  }
  return text;
}

// A tetrahedron as an ascii PLY file.
inline const char* const tetrahedron_ply =
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\nproperty double y\n"
    "property double z\nelement face 4\nproperty list uchar int vertex_indices\nend_header\n"
    "0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";

}  // namespace cocoon::test
