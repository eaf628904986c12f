#include "geom/angles.h"

#include <algorithm>
#include <cmath>

#include "geom/scaled_to_one.h"

namespace cocoon {

namespace {

// acos loses half the digits near 0 and pi; atan2 does not. NaN where an angle is not defined.
double angle_between(const Vec3& u, const Vec3& v) {
  if (u == Vec3{} || v == Vec3{}) return std::nan("");
  return std::atan2(norm(cross(u, v)), dot(u, v));
}

}  // namespace

double wedge_angle(const Point& edge_from, const Point& edge_to, const Point& apex_a,
                   const Point& apex_b) {
  // The normals of the two half planes, both turned the same way about the edge.
  const Vec3 edge = scaled_to_one(edge_to - edge_from);
  return angle_between(scaled_to_one(cross(edge, scaled_to_one(apex_a - edge_from))),
                       scaled_to_one(cross(edge, scaled_to_one(apex_b - edge_from))));
}

double literal_dihedral(const Point& edge_from, const Point& edge_to, const Point& apex_a,
                        const Point& apex_b) {
  const Vec3 p0p1 = edge_to - edge_from;
  const Vec3 n_c = unit(cross(p0p1, apex_a - edge_from));
  const Vec3 n_k = unit(cross(apex_b - edge_from, p0p1));
  return std::acos(std::clamp(dot(n_c, n_k), -1.0, 1.0));
}

}  // namespace cocoon
