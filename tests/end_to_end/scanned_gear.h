// A part of few, large triangles, and a scan of its change.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "tests/run_program.h"
#include "tests/test_clouds.h"

namespace cocoon::test {

inline constexpr double height = 1.5;  // of the part

// A disk with ten teeth.
inline std::string gear(double thickness = height) {
  constexpr int count = 20;
  std::string vertices;
  std::string triangles;
  const auto triangle = [&](int a, int b, int c) {
    triangles +=
        "3 " + std::to_string(a) + " " + std::to_string(b) + " " + std::to_string(c) + "\n";
  };
  for (const double z : {0.0, thickness}) {
    for (int k = 0; k < count; ++k) {
      const double radius = k % 2 == 0 ? 2 : 3;
      const double angle = 2 * std::numbers::pi * k / count;
      vertices += point_line(radius * std::cos(angle), radius * std::sin(angle), z);
    }
  }
  vertices += point_line(0, 0, 0) + point_line(0, 0, thickness);
  for (int k = 0; k < count; ++k) {
    const int next = (k + 1) % count;
    triangle(2 * count, next, k);
    triangle(2 * count + 1, count + k, count + next);
    triangle(k, next, count + next);
    triangle(k, count + next, count + k);
  }
  return "OFF\n42 80 0\n" + vertices + triangles;
}

// A knob in the middle of its upper side, or so far above it.
inline std::string knob(double above = 0) {
  std::string cloud;
  for (int i = 0; i < 330; ++i) {
    const double radius = std::sqrt((i + 0.5) / 330);
    const double bump = std::max(0.0, 1 - 2.5 * radius * radius);
    cloud += point_line(radius * std::cos(2.4 * i), radius * std::sin(2.4 * i),
                        height + above + 0.3 * bump * bump);
  }
  return cloud;
}

// Both as files.
struct ScannedGear {
  TemporaryFolder folder;
  std::string part = folder.write("part.off", gear());
  std::string cloud = folder.write("knob.xyz", knob());
};

}  // namespace cocoon::test
