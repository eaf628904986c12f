// Point samples of known surfaces, the same bits everywhere, for the tests of the Cocone stages.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <vector>

#include "geom/point.h"
#include "geom/random/random.h"

namespace cocoon::shapes {

inline std::vector<Point> sphere(std::size_t count, std::uint64_t seed, double radius = 1,
                                 Point center = {}) {
  Random random(seed);
  std::vector<Point> points;
  while (points.size() < count) points.push_back(center + radius * random.on_unit_sphere());
  return points;
}

// Radii multiplied by 1 + noise times a normal variable.
inline std::vector<Point> noisy_sphere(std::size_t count, double noise, std::uint64_t seed) {
  Random random(seed);
  std::vector<Point> points;
  while (points.size() < count) {
    const Point p = random.on_unit_sphere();
    points.push_back((1 + noise * random.gaussian()) * p);
  }
  return points;
}

inline std::vector<Point> ellipsoid(std::size_t count, std::uint64_t seed) {
  std::vector<Point> points = sphere(count, seed);
  for (Point& p : points) p = {p.x, 0.75 * p.y, 0.5 * p.z};
  return points;
}

// A jittered grid on a torus with radii 1 and `tube`, rows x columns points.
inline std::vector<Point> torus(std::size_t rows, std::size_t columns, double tube, double jitter,
                                std::uint64_t seed) {
  Random random(seed);
  std::vector<Point> points;
  const double turn = 2 * std::numbers::pi;
  for (std::size_t i = 0; i < rows; ++i) {
    for (std::size_t k = 0; k < columns; ++k) {
      const double u =
          turn * (static_cast<double>(i) + jitter * random.uniform()) / static_cast<double>(rows);
      const double v = turn * (static_cast<double>(k) + jitter * random.uniform()) /
                       static_cast<double>(columns);
      const double ring = 1 + tube * std::cos(v);
      points.push_back({ring * std::cos(u), ring * std::sin(u), tube * std::sin(v)});
    }
  }
  return points;
}

// Uniform by area.
inline std::vector<Point> random_torus(std::size_t count, double tube, std::uint64_t seed) {
  Random random(seed);
  std::vector<Point> points;
  const double turn = 2 * std::numbers::pi;
  while (points.size() < count) {
    const double u = turn * random.uniform();
    const double v = turn * random.uniform();
    const double ring = 1 + tube * std::cos(v);
    if (random.uniform() * (1 + tube) > ring) continue;
    points.push_back({ring * std::cos(u), ring * std::sin(u), tube * std::sin(v)});
  }
  return points;
}

// All points of the grid {0..steps}^3 on the surface of the cube.
inline std::vector<Point> cube_grid(int steps) {
  std::vector<Point> points;
  for (int x = 0; x <= steps; ++x) {
    for (int y = 0; y <= steps; ++y) {
      for (int z = 0; z <= steps; ++z) {
        if (x % steps == 0 || y % steps == 0 || z % steps == 0) {
          points.push_back({double(x), double(y), double(z)});
        }
      }
    }
  }
  return points;
}

// Two poles and `rows` parallels of `columns` points.
inline std::vector<Point> latitude_sphere(std::size_t rows, std::size_t columns) {
  std::vector<Point> points{{0, 0, 1}, {0, 0, -1}};
  for (std::size_t i = 1; i <= rows; ++i) {
    const double polar = std::numbers::pi * static_cast<double>(i) / static_cast<double>(rows + 1);
    for (std::size_t k = 0; k < columns; ++k) {
      const double u = 2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(columns);
      points.push_back(
          {std::sin(polar) * std::cos(u), std::sin(polar) * std::sin(u), std::cos(polar)});
    }
  }
  return points;
}

// The part of a random sphere with z < height.
inline std::vector<Point> cut_sphere(std::size_t count, double height, std::uint64_t seed) {
  Random random(seed);
  std::vector<Point> points;
  while (points.size() < count) {
    const Point p = random.on_unit_sphere();
    if (p.z < height) points.push_back(p);
  }
  return points;
}

// A jittered grid over [0,1]^2, lifted to a gentle dome.
inline std::vector<Point> dome_patch(int side, double jitter, std::uint64_t seed) {
  Random random(seed);
  std::vector<Point> points;
  for (int i = 0; i < side; ++i) {
    for (int k = 0; k < side; ++k) {
      const double x = (i + jitter * random.uniform(-0.5, 0.5)) / (side - 1);
      const double y = (k + jitter * random.uniform(-0.5, 0.5)) / (side - 1);
      points.push_back({x, y, -0.4 * ((x - 0.5) * (x - 0.5) + (y - 0.5) * (y - 0.5))});
    }
  }
  return points;
}

// A Moebius strip of radius 1, points moved by `jitter` spacings in it and a tenth of that off it.
inline std::vector<Point> moebius_strip(int columns, int rows, double jitter, std::uint64_t seed) {
  Random random(seed);
  const double step = 2 * std::numbers::pi / columns;
  std::vector<Point> points;
  for (int i = 0; i < columns; ++i) {
    for (int j = 0; j < rows; ++j) {
      const double u = step * (i + random.uniform(-0.5, 0.5) * jitter);
      const double across = step * (j - 0.5 * (rows - 1) + random.uniform(-0.5, 0.5) * jitter);
      const double off = 0.1 * step * random.uniform(-0.5, 0.5) * jitter;
      const Vec3 out{std::cos(u), std::sin(u), 0};
      const Vec3 up{0, 0, 1};
      const Vec3 along = std::cos(0.5 * u) * out + std::sin(0.5 * u) * up;
      const Vec3 normal = std::cos(0.5 * u) * up - std::sin(0.5 * u) * out;
      points.push_back(Point(out + across * along + off * normal));
    }
  }
  return points;
}

// A plate of `layers` + 1 grid layers of side x side points each: only its surface is sampled.
inline std::vector<Point> plate(int side, int layers) {
  std::vector<Point> points;
  for (int x = 0; x < side; ++x) {
    for (int y = 0; y < side; ++y) {
      for (int z = 0; z <= layers; ++z) {
        const bool on_rim = x == 0 || y == 0 || x == side - 1 || y == side - 1;
        if (on_rim || z == 0 || z == layers) points.push_back({double(x), double(y), double(z)});
      }
    }
  }
  return points;
}

inline std::vector<Point> random_cube(std::size_t count, std::uint64_t seed) {
  Random random(seed);
  std::vector<Point> points;
  while (points.size() < count) points.push_back(random.in_unit_cube());
  return points;
}

inline std::vector<Point> joined(std::vector<Point> a, const std::vector<Point>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

inline std::vector<Point> moved(std::vector<Point> points, Vec3 offset) {
  for (Point& p : points) p = p + offset;
  return points;
}

inline std::vector<Point> shuffled(std::vector<Point> points, std::uint64_t seed) {
  Random(seed).shuffle(points);
  return points;
}

}  // namespace cocoon::shapes
