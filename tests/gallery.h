// Point sets for tests and benchmarks: ordinary ones, and the degenerate ones that break kernels.
// All are made from fixed seeds by geom/random/random.h: the same on every machine but for the last
// bit of sin, cos and log.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <limits>
#include <numbers>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "geom/point.h"
#include "geom/random/random.h"

namespace cocoon::gallery {

// --- Generic positions -------------------------------------------------------------------------

inline std::vector<Point> uniform_cube(std::size_t count, std::uint64_t seed = 1) {
  Random random(seed);
  std::vector<Point> points(count);
  for (Point& p : points) p = random.in_unit_cube();
  return points;
}

// The unit sphere, rounded to double: nearly but not exactly cospherical.
inline std::vector<Point> sphere(std::size_t count, std::uint64_t seed = 1) {
  Random random(seed);
  std::vector<Point> points(count);
  for (Point& p : points) p = random.on_unit_sphere();
  return points;
}

// A scan-like torus, radii 1 and 0.35 with a displacement wave: jittered parameter grid, noise.
// Returns the largest number of points m * n <= count with m about 3 n.
inline std::vector<Point> displaced_torus(std::size_t count, std::uint64_t seed = 1,
                                          double noise = 1e-5) {
  Random random(seed);
  const auto around =
      std::max<std::size_t>(3, static_cast<std::size_t>(std::sqrt(static_cast<double>(count) / 3)));
  const std::size_t along = std::max<std::size_t>(3, count / around);
  std::vector<Point> points;
  points.reserve(along * around);
  for (std::size_t i = 0; i < along; ++i) {
    for (std::size_t j = 0; j < around; ++j) {
      const double u = 2 * std::numbers::pi * (static_cast<double>(i) + random.uniform()) /
                       static_cast<double>(along);
      const double v = 2 * std::numbers::pi * (static_cast<double>(j) + random.uniform()) /
                       static_cast<double>(around);
      const double tube =
          0.35 * (1 + 0.1 * std::sin(5 * u) * std::cos(3 * v)) + noise * random.gaussian();
      const double ring = 1 + tube * std::cos(v);
      points.push_back({ring * std::cos(u), ring * std::sin(u), tube * std::sin(v)});
    }
  }
  return points;
}

// The unit sphere along a spiral of even density.
inline std::vector<Point> even_sphere(std::size_t count) {
  std::vector<Point> points;
  const double turn = std::numbers::pi * (3 - std::sqrt(5.0));
  for (std::size_t i = 0; i < count; ++i) {
    const double z = 1 - (2 * static_cast<double>(i) + 1) / static_cast<double>(count);
    const double r = std::sqrt(1 - z * z);
    const double angle = turn * static_cast<double>(i);
    points.push_back({r * std::cos(angle), r * std::sin(angle), z});
  }
  return points;
}

// A sphere with bumps along a jittered spiral of even density, noise.
inline std::vector<Point> bumpy_sphere(std::size_t count, std::uint64_t seed = 1,
                                       double noise = 1e-5) {
  Random random(seed);
  const double golden_angle = std::numbers::pi * (3 - std::sqrt(5.0));
  std::vector<Point> points(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double t = (static_cast<double>(i) + random.uniform()) / static_cast<double>(count);
    const double angle = golden_angle * (static_cast<double>(i) + 0.3 * random.uniform());
    const double z = 1 - 2 * t;
    const double ring = std::sqrt(std::max(0.0, 1 - z * z));
    const double radius =
        1 + 0.1 * std::sin(6 * angle) * std::sin(5 * z) * ring + noise * random.gaussian();
    points[i] = {radius * ring * std::cos(angle), radius * ring * std::sin(angle), radius * z};
  }
  return points;
}

// Dense Gaussian clusters (deviation 1e-4) around a few centers: very uneven density.
inline std::vector<Point> clusters(std::size_t count, std::uint64_t seed = 1) {
  Random random(seed);
  const std::vector<Point> centers = uniform_cube(10, seed + 1);
  std::vector<Point> points(count);
  for (Point& p : points) {
    const Vec3 offset{random.gaussian(), random.gaussian(), random.gaussian()};
    p = centers[random.below(centers.size())] + 1e-4 * offset;
  }
  return points;
}

// --- Many cospherical or coplanar points, exactly ----------------------------------------------

// The integer points [0, n)^3.
inline std::vector<Point> integer_grid(int n) {
  std::vector<Point> points;
  for (int x = 0; x < n; ++x) {
    for (int y = 0; y < n; ++y) {
      for (int z = 0; z < n; ++z) {
        points.push_back({static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)});
      }
    }
  }
  return points;
}

// All integer points at squared distance `square` from the origin: exactly cospherical.
inline std::vector<Point> integer_sphere(int square) {
  std::vector<Point> points;
  const int bound = static_cast<int>(std::sqrt(static_cast<double>(square))) + 1;
  for (int x = -bound; x <= bound; ++x) {
    for (int y = -bound; y <= bound; ++y) {
      for (int z = -bound; z <= bound; ++z) {
        if (x * x + y * y + z * z != square) continue;
        points.push_back({static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)});
      }
    }
  }
  return points;
}

// A regular grid on the six faces of a box of 2 x 1.5 x 1, 4k x 3k x 2k squares: flat faces with
// cocircular quadruples, edges and corners shared.
inline std::vector<Point> box_faces(int k) {
  const double step = 0.5 / k;
  std::vector<Point> points;
  for (int x = 0; x <= 4 * k; ++x) {
    for (int y = 0; y <= 3 * k; ++y) {
      for (int z = 0; z <= 2 * k; ++z) {
        const bool on_face = x % (4 * k) == 0 || y % (3 * k) == 0 || z % (2 * k) == 0;
        if (on_face) points.push_back({x * step, y * step, z * step});
      }
    }
  }
  return points;
}

// A flat grid and one apex above it: one side of every circumsphere ties.
inline std::vector<Point> plane_and_apex(int n) {
  std::vector<Point> points;
  for (int x = 0; x < n; ++x) {
    for (int y = 0; y < n; ++y) {
      points.push_back({static_cast<double>(x), static_cast<double>(y), 0});
    }
  }
  points.push_back({0.5 * n, 0.25 * n, 1.0 * n});
  return points;
}

// Two skew lines: every segment of one and every segment of the other span a cell, O(n^2) cells.
inline std::vector<Point> two_lines(int per_line) {
  std::vector<Point> points;
  for (int i = 0; i < per_line; ++i) {
    points.push_back({static_cast<double>(i), 0, 0});
    points.push_back({0, static_cast<double>(i), 1});
  }
  return points;
}

// Rings of integer points with the radii of Pythagorean triples on the planes z = 0, 1, ...: exact
// circles, and cospherical from ring to ring.
inline std::vector<Point> cylinder(int height) {
  std::vector<Point> points;
  for (const Point& p : integer_sphere(65 * 65)) {
    if (p.z != 0) continue;
    for (int z = 0; z < height; ++z) points.push_back({p.x, p.y, static_cast<double>(z)});
  }
  return points;
}

// --- Close together, far away, repeated ---------------------------------------------------------

// Each point of a random set again with one coordinate moved to the next double.
inline std::vector<Point> ulp_pairs(std::size_t pairs, std::uint64_t seed = 1) {
  std::vector<Point> points = uniform_cube(pairs, seed);
  for (std::size_t i = 0; i < pairs; ++i) {
    Point p = points[i];
    double& moved = i % 3 == 0 ? p.x : i % 3 == 1 ? p.y : p.z;
    moved = std::nextafter(moved, 2.0);
    points.push_back(p);
  }
  return points;
}

// The 3 x 3 x 3 doubles around each of a few points: grids with steps of one ulp.
inline std::vector<Point> ulp_grids(std::size_t count, std::uint64_t seed = 1) {
  std::vector<Point> points;
  const double ulp = std::numeric_limits<double>::epsilon() / 2;  // of [0.5, 1)
  for (const Point& p : uniform_cube(count, seed)) {
    const Point base{0.5 + p.x / 4, 0.5 + p.y / 4, 0.5 + p.z / 4};
    for (const Point& step : integer_grid(3)) points.push_back(base + ulp * step);
  }
  return points;
}

inline std::vector<Point> scaled(std::vector<Point> points, double factor) {
  for (Point& p : points) p = factor * p;
  return points;
}

inline std::vector<Point> shifted(std::vector<Point> points, const Vec3& offset) {
  for (Point& p : points) p = p + offset;
  return points;
}

// Every point `times` times.
inline std::vector<Point> repeated(const std::vector<Point>& points, int times) {
  std::vector<Point> result;
  for (int i = 0; i < times; ++i) result.insert(result.end(), points.begin(), points.end());
  return result;
}

inline std::vector<Point> shuffled(std::vector<Point> points, std::uint64_t seed = 1) {
  Random(seed).shuffle(points);
  return points;
}

// --- Files ---------------------------------------------------------------------------------------

// The first three numbers of each line. On purpose not io/: the kernel's tests depend on geom and
// delaunay only. Throws std::runtime_error if there are none.
inline std::vector<Point> read_xyz(const std::string& path) {
  std::ifstream file(path);
  std::vector<Point> points;
  std::string line;
  while (std::getline(file, line)) {
    std::istringstream words(line);
    Point p;
    if (words >> p.x >> p.y >> p.z) points.push_back(p);
  }
  if (points.empty()) throw std::runtime_error("no points in " + path);
  return points;
}

}  // namespace cocoon::gallery
