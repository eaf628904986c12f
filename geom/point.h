// Points and vectors of space, and the few operations on them that every layer needs.
//
// A plain struct and not Eigen::Vector3d: the order of the additions is written here, so results
// are the same bits with every compiler and instruction set, and the kernel's headers stay cheap
// to compile. Eigen is used where there is linear algebra to do (eigenvectors, fits).
#pragma once

#include <algorithm>
#include <cmath>
#include <compare>
#include <span>

namespace cocoon {

struct Vec3 {
  double x = 0;
  double y = 0;
  double z = 0;

  // Lexicographic order of coordinates: the tie rule of the whole project. -0.0 equals 0.0.
  friend constexpr auto operator<=>(const Vec3&, const Vec3&) = default;

  constexpr double operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
};

using Point = Vec3;
using Points = std::span<const Point>;

constexpr Vec3 operator+(const Vec3& a, const Vec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
constexpr Vec3 operator-(const Vec3& a, const Vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
constexpr Vec3 operator-(const Vec3& a) { return {-a.x, -a.y, -a.z}; }
constexpr Vec3 operator*(double s, const Vec3& a) { return {s * a.x, s * a.y, s * a.z}; }
constexpr Vec3 operator*(const Vec3& a, double s) { return s * a; }
constexpr Vec3 operator/(const Vec3& a, double s) { return {a.x / s, a.y / s, a.z / s}; }

constexpr double dot(const Vec3& a, const Vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
constexpr Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
constexpr double squared_norm(const Vec3& a) { return dot(a, a); }
inline double norm(const Vec3& a) { return std::sqrt(squared_norm(a)); }
constexpr double squared_distance(const Point& a, const Point& b) { return squared_norm(a - b); }
// The largest |coordinate|.
inline double max_norm(const Vec3& a) {
  return std::max(std::max(std::fabs(a.x), std::fabs(a.y)), std::fabs(a.z));
}
inline double distance(const Point& a, const Point& b) { return norm(a - b); }

// a / |a|, of lengths within 2^-500 to 2^500; the zero vector for |a| = 0 or not finite.
inline Vec3 unit(const Vec3& a) {
  const double length = norm(a);
  if (!(length > 0) || !std::isfinite(length)) return {};
  return a / length;
}

inline bool is_finite(const Point& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

}  // namespace cocoon
