#include "io/models/implicit_solid.h"

#include <algorithm>
#include <cmath>

namespace cocoon {

double rounded_box(const Point& p, const Vec3& half, double radius) {
  const Vec3 beyond = {std::abs(p.x) - half.x + radius, std::abs(p.y) - half.y + radius,
                       std::abs(p.z) - half.z + radius};
  const Vec3 outside = {std::max(beyond.x, 0.0), std::max(beyond.y, 0.0), std::max(beyond.z, 0.0)};
  return norm(outside) + std::min(std::max({beyond.x, beyond.y, beyond.z}), 0.0) - radius;
}

double rounded_extrusion(double figure, double height, double radius) {
  const double u = figure + radius;
  const double v = height + radius;
  const Vec3 outside = {std::max(u, 0.0), std::max(v, 0.0), 0};
  return norm(outside) + std::min(std::max(u, v), 0.0) - radius;
}

double filleted_union(double a, double b, double width) {
  const double blend = std::max(width - std::abs(a - b), 0.0);
  return std::min(a, b) - blend * blend / (4 * width);
}

double filleted_intersection(double a, double b, double width) {
  return -filleted_union(-a, -b, width);
}

double filleted_difference(double a, double b, double width) {
  return -filleted_union(-a, b, width);
}

double round_cone(const Point& p, const Point& a, double radius_a, const Point& b,
                  double radius_b) {
  // The solid is swept by a ball whose center moves from a to b. The ball closest to p is the one
  // whose distance, sqrt(across^2 + (along - h)^2) - radius_a + slope h, is least:
  // h = along - across slope / sqrt(1 - slope^2), within the segment.
  const double length = distance(a, b);
  const Vec3 axis = (b - a) / length;
  const double slope = (radius_a - radius_b) / length;
  const double along = dot(p - a, axis);
  const double across = norm(p - a - along * axis);
  const double h = std::clamp(along - across * slope / std::sqrt(1 - slope * slope), 0.0, length);
  return std::sqrt(across * across + (along - h) * (along - h)) - radius_a + slope * h;
}

double ellipsoid(const Point& p, const Vec3& half) {
  const Vec3 once = {p.x / half.x, p.y / half.y, p.z / half.z};
  const Vec3 twice = {once.x / half.x, once.y / half.y, once.z / half.z};
  if (norm(twice) == 0) return -std::min({half.x, half.y, half.z});
  return norm(once) * (norm(once) - 1) / norm(twice);
}

Vec3 gradient(const ImplicitFunction& f, const Point& p, double step) {
  const auto slope = [&](const Vec3& along) { return (f(p + along) - f(p - along)) / (2 * step); };
  return {slope({step, 0, 0}), slope({0, step, 0}), slope({0, 0, step})};
}

Point project_to_surface(const ImplicitFunction& f, const Point& p, double step) {
  constexpr int max_steps = 8;
  const double close_enough = 1e-9 * step;
  Point q = p;
  for (int k = 0; k < max_steps; ++k) {
    const double value = f(q);
    const Vec3 slope = gradient(f, q, step);
    const double steepness = squared_norm(slope);
    if (std::abs(value) <= close_enough || steepness == 0) break;
    q = q - (value / steepness) * slope;
  }
  return q;
}

}  // namespace cocoon
