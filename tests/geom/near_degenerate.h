// Random points that are hard for a predicate, from fixed seeds.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <ostream>
#include <random>

#include "geom/point.h"
#include "geom/sign.h"

namespace cocoon {

inline std::ostream& operator<<(std::ostream& out, const Vec3& p) {
  return out << std::hexfloat << '(' << p.x << ", " << p.y << ", " << p.z << ')';
}

inline std::ostream& operator<<(std::ostream& out, Sign s) { return out << static_cast<int>(s); }

}  // namespace cocoon

namespace cocoon::test {

// Each family aims at one weakness: rounding, underflow, overflow, exponent spread, exact zeros.
enum class Family {
  random,       // uniform in a cube
  coplanar,     // within an ulp of a plane
  cospherical,  // within an ulp of a sphere
  far_sphere,   // the same, 1e7 radii from the origin
  grid,         // small integers: exact zeros are frequent
  flat,         // one axis 1e-9 of the others
  subnormal,    // multiples of the smallest subnormal
  tiny,         // cospherical * 1e-150
  huge,         // cospherical * 1e150
  largest,      // up to the largest double: differences overflow
  mixed,        // every coordinate with its own exponent
  last
};

class NearDegenerate {
 public:
  explicit NearDegenerate(unsigned seed) : random_(seed) {}

  std::array<Point, 5> points(Family family) {
    std::array<Point, 5> p;
    if (family == Family::coplanar) return coplanar();
    for (Point& q : p) q = point(family);
    return p;
  }

  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  int integer(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }

 private:
  Point in_cube() { return {uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)}; }
  double nudge(double x) {
    const int step = integer(-1, 1);
    return step == 0 ? x : std::nextafter(x, step * std::numeric_limits<double>::infinity());
  }
  Point nudge(const Point& p) { return {nudge(p.x), nudge(p.y), nudge(p.z)}; }
  Point on_sphere() { return nudge(unit(in_cube())); }
  double any_exponent() { return std::ldexp(uniform(-1, 1), integer(-1074, 1023)); }

  Point point(Family family) {
    switch (family) {
      case Family::cospherical:
        return on_sphere();
      case Family::far_sphere:
        return on_sphere() + Point{1e7, -2e7, 3e7};
      case Family::grid:
        return {1.0 * integer(-2, 2), 1.0 * integer(-2, 2), 1.0 * integer(-2, 2)};
      case Family::flat:
        return {uniform(-1, 1), uniform(-1, 1), uniform(-1e-9, 1e-9)};
      case Family::subnormal:
        return {integer(-3, 3) * 0x1p-1074, integer(-3, 3) * 0x1p-1074, integer(-3, 3) * 0x1p-1074};
      case Family::tiny:
        return on_sphere() * 1e-150;
      case Family::huge:
        return on_sphere() * 1e150;
      case Family::largest:
        return in_cube() * std::numeric_limits<double>::max();
      case Family::mixed:
        return {any_exponent(), any_exponent(), any_exponent()};
      default:
        return in_cube();
    }
  }

  std::array<Point, 5> coplanar() {
    const Point a = in_cube();
    const Point b = in_cube();
    const Point c = in_cube();
    const auto in_plane = [&] {
      return nudge(a + uniform(-1, 1) * (b - a) + uniform(-1, 1) * (c - a));
    };
    return {a, b, c, in_plane(), in_plane()};
  }

  std::mt19937_64 random_;
};

}  // namespace cocoon::test
