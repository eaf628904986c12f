// Views of one place that are out of register, so that their samples lie in layers.
#pragma once

#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "geom/point.h"
#include "geom/random/random.h"
#include "tests/gallery.h"

namespace cocoon::test {

constexpr std::size_t samples_of_ball = 3000;
const double spacing_of_ball = std::sqrt(4 * std::numbers::pi / samples_of_ball);

// The unit sphere, each sample moved by up to `noise`.
inline std::vector<Point> noisy_ball(double noise, Random& random) {
  std::vector<Point> points = gallery::even_sphere(samples_of_ball);
  for (Point& p : points) {
    for (double* c : {&p.x, &p.y, &p.z}) *c += random.uniform(-noise, noise);
  }
  return points;
}

// Six views of its cap above z = 0.75, each turned about the axis and moved by up to `shift`.
inline std::vector<Point> layered_cap(double shift, Random& random) {
  std::vector<Point> points;
  for (int view = 0; view < 6; ++view) {
    Vec3 by{};
    for (double* c : {&by.x, &by.y, &by.z}) *c = random.uniform(-shift, shift);
    const double turn = random.uniform(0, 6);
    for (const Point& p : noisy_ball(0.05 * spacing_of_ball, random)) {
      if (p.z < 0.75) continue;
      points.push_back(Point{p.x * std::cos(turn) - p.y * std::sin(turn),
                             p.x * std::sin(turn) + p.y * std::cos(turn), p.z} +
                       by);
    }
  }
  return points;
}

}  // namespace cocoon::test
