#include "geom/angles.h"

#include <algorithm>
#include <cmath>

namespace cocoon {

namespace {

// v times the power of two that brings its largest coordinate to [1, 2): exact but for coordinates
// 2^1000 times smaller, and no square of it over- or underflows. The zero vector stays.
Vec3 scaled(const Vec3& v) {
  const double reach = max_norm(v);
  if (!(reach > 0) || !std::isfinite(reach)) return v;
  const int exponent = -std::ilogb(reach);
  const double power = std::ldexp(1.0, exponent);
  if (std::isfinite(power)) return power * v;  // one call, and the same numbers
  return {std::ldexp(v.x, exponent), std::ldexp(v.y, exponent), std::ldexp(v.z, exponent)};
}

// acos loses half the digits near 0 and pi; atan2 does not. NaN where an angle is not defined.
double angle_between(const Vec3& u, const Vec3& v) {
  if (u == Vec3{} || v == Vec3{}) return std::nan("");
  return std::atan2(norm(cross(u, v)), dot(u, v));
}

}  // namespace

double wedge_angle(const Point& edge_from, const Point& edge_to, const Point& apex_a,
                   const Point& apex_b) {
  // The normals of the two half planes, both turned the same way about the edge.
  const Vec3 edge = scaled(edge_to - edge_from);
  return angle_between(scaled(cross(edge, scaled(apex_a - edge_from))),
                       scaled(cross(edge, scaled(apex_b - edge_from))));
}

double literal_dihedral(const Point& edge_from, const Point& edge_to, const Point& apex_a,
                        const Point& apex_b) {
  const Vec3 p0p1 = edge_to - edge_from;
  const Vec3 n_c = unit(cross(p0p1, apex_a - edge_from));
  const Vec3 n_k = unit(cross(apex_b - edge_from, p0p1));
  return std::acos(std::clamp(dot(n_c, n_k), -1.0, 1.0));
}

}  // namespace cocoon
