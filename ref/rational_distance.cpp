#include "ref/rational_distance.h"

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cstddef>

namespace cocoon::ref {
namespace {

using Rational = boost::multiprecision::cpp_rational;
using Vector = std::array<Rational, 3>;

Vector difference(const Point& p, const Point& q) {
  return {Rational(p.x) - Rational(q.x), Rational(p.y) - Rational(q.y),
          Rational(p.z) - Rational(q.z)};
}

Rational dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Rational squared_distance_to_segment(const Point& p, const Point& a, const Point& b) {
  const Vector along = difference(b, a);
  const Vector from_a = difference(p, a);
  const Vector from_b = difference(p, b);
  const Rational t = dot(from_a, along);
  if (t <= 0) return dot(from_a, from_a);
  if (dot(from_b, along) >= 0) return dot(from_b, from_b);
  return dot(from_a, from_a) - t * t / dot(along, along);
}

}  // namespace

double squared_distance_to_triangle(const Point& p, const TrianglePoints& triangle) {
  const Vector normal =
      cross(difference(triangle[1], triangle[0]), difference(triangle[2], triangle[0]));
  const Rational squared_area = dot(normal, normal);
  Rational best = squared_distance_to_segment(p, triangle[2], triangle[0]);
  bool inside = squared_area > 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Point& from = triangle[i];
    const Point& to = triangle[(i + 1) % 3];
    best = std::min(best, squared_distance_to_segment(p, from, to));
    inside = inside && dot(cross(difference(to, from), difference(p, from)), normal) >= 0;
  }
  if (inside) {
    const Rational height = dot(difference(p, triangle[0]), normal);
    best = height * height / squared_area;
  }
  return best.convert_to<double>();
}

}  // namespace cocoon::ref
