// Angles between lines and at edges, in radians, and comparisons of them without acos, which
// differs between C libraries.
#pragma once

#include "geom/point.h"

namespace cocoon {

// Angle in [0, pi/2] between the lines along u and v. NaN if one of them is zero.
// Any magnitudes: both are scaled by powers of two first.
double line_angle(const Vec3& u, const Vec3& v);

// Is the angle in [0, pi/2] between the lines along u and v at least acos(cosine)? Compares
// (u . v)^2 <= cosine^2 |u|^2 |v|^2: no root, no acos. True if one of them is zero: a zero vector
// has every angle (cocone condition at a Voronoi vertex on the sample itself).
// Precondition: cosine in [0, 1]; |u|^2 |v|^2 neither over- nor underflows.
constexpr bool line_angle_at_least(const Vec3& u, const Vec3& v, double cosine) {
  const double product = dot(u, v);
  return product * product <= cosine * cosine * (squared_norm(u) * squared_norm(v));
}

// Angle in [0, pi] at which the half planes from the edge through apex_a and through apex_b meet:
// the angle between the parts of apex_a - edge_from and apex_b - edge_from orthogonal to the edge.
// 0: one folded onto the other, pi: a smooth continuation. NaN if the edge has no length or an apex
// lies on its line. Symmetric in the apexes and, up to rounding, in the ends of the edge. Absolute
// error a few 2^-53 for well-shaped triangles: atan2 of both components, so no loss near 0 and pi.
// Source: the angle of Woo & Dey 2005 section 3.4 as its text and figures need it; see
// literal_dihedral for the printed equations.
double wedge_angle(const Point& edge_from, const Point& edge_to, const Point& apex_a,
                   const Point& apex_b);

// Cosine of wedge_angle, in [-1, 1]: decreases as the angle grows, so comparisons need no acos.
double wedge_cosine(const Point& edge_from, const Point& edge_to, const Point& apex_a,
                    const Point& apex_b);

// Woo & Dey 2005, Eq. 4-5 as printed, P0 = edge_from, P1 = edge_to, P2 = apex_a, P3 = apex_b:
//   (4) n_c = P0P1 x P0P2 / |.|,  n_k = P0P3 x P0P1 / |.|
//   (5) theta = arccos(n_c . n_k)
// The order of the factors in (4) orients both triangles alike, so theta is 0 for a smooth
// continuation: pi - wedge_angle. Kept for comparison only; nothing decides by it.
double literal_dihedral(const Point& edge_from, const Point& edge_to, const Point& apex_a,
                        const Point& apex_b);

}  // namespace cocoon
