#include "io/implicit_solid.h"

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
