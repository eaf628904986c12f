#include "docs/pictures/scans.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "geom/random/random.h"

namespace cocoon::pictures {
namespace {

constexpr double spacing = 0.15;
constexpr double closest = 0.8;  // in spacings
constexpr int trials = 60000;
constexpr double degree = std::numbers::pi / 180;

Vec3 in_plane(double angle) { return {std::cos(angle), std::sin(angle), 0}; }

double angle_between(const Vec3& a, const Vec3& b) {
  return std::acos(std::clamp(dot(a, b), -1.0, 1.0));
}

double hill(const Vec3& u, double at, double width) {
  const double t = angle_between(u, in_plane(at)) / width;
  return std::exp(-t * t);
}

// In direction u from the origin.
Point on_body(const Vec3& u) {
  return (0.95 + 0.75 * hill(u, 15 * degree, 0.16) + 0.3 * hill(u, 195 * degree, 0.7) -
          0.4 * hill(u, 105 * degree, 0.42)) *
         u;
}

bool is_scanned(const Vec3& u) { return angle_between(u, in_plane(-95 * degree)) > 0.85; }

// Adds p if no sample is too close.
void offer(std::vector<Point>& samples, const Point& p) {
  const double limit = closest * closest * spacing * spacing;
  const bool is_free = std::none_of(samples.begin(), samples.end(),
                                    [&](const Point& q) { return squared_distance(p, q) < limit; });
  if (is_free) samples.push_back(p);
}

constexpr double length_of_edge = 2;
constexpr double depth_of_edge = 1.6;  // from the edge to the back
const double half_width = depth_of_edge * std::tan(30 * degree);

// On the sides that meet at the edge and on the back, t from 0 to 1.
Planar on_profile(std::size_t side, double t) {
  const std::array<Planar, 3> corners = {
      {{0, 0}, {depth_of_edge, half_width}, {depth_of_edge, -half_width}}};
  return corners[side] + t * (corners[(side + 1) % 3] - corners[side]);
}

Point with_noise(const Planar& p, double z, Random& random) {
  constexpr double noise = 0.15 * spacing;
  const double x = p.x + noise * random.gaussian();
  return {x, p.y + noise * random.gaussian(), z};
}

}  // namespace

std::vector<Planar> outline_of_body() {
  std::vector<Planar> outline;
  for (int k = 0; k < 720; ++k) {
    const Point p = on_body(in_plane(0.5 * k * degree));
    outline.push_back({p.x, p.y});
  }
  return outline;
}

std::vector<Point> scan_of_body() {
  Random random(7);
  std::vector<Point> samples;
  double way = spacing;  // since the last sample on the outline
  Point before = on_body(in_plane(0));
  constexpr int steps = 7200;
  for (int k = 0; k < steps; ++k) {
    const Vec3 u = in_plane(360 * degree * k / steps);
    const Point p = on_body(u);
    way += distance(before, p);
    before = p;
    if (way < spacing * (0.95 + 0.1 * random.uniform()) || !is_scanned(u)) continue;
    offer(samples, p);
    way = 0;
  }
  for (int k = 0; k < trials; ++k) {
    const Vec3 u = random.on_unit_sphere();
    if (is_scanned(u)) offer(samples, on_body(u));
  }
  return samples;
}

std::vector<Point> scan_of_edge() {
  Random random(166);
  std::vector<Point> samples;
  for (std::size_t side = 0; side < 3; ++side) {
    const Planar way = on_profile(side, 1) - on_profile(side, 0);
    const int count = static_cast<int>(std::hypot(way.x, way.y) / spacing);
    for (int k = 0; k < count; ++k) {
      const double t = (k + 0.5 * random.uniform()) / count;
      offer(samples, with_noise(on_profile(side, t), 0, random));
    }
  }
  for (int k = 0; k < trials; ++k) {
    const std::size_t side = random.below(3);
    const Planar p = on_profile(side, random.uniform());
    const double z = length_of_edge * (random.uniform() - 0.5);
    offer(samples, with_noise(p, z, random));
  }
  return samples;
}

}  // namespace cocoon::pictures
