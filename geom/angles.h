// Angles at edges, in radians. Complexity of all: O(1).
#pragma once

#include <numbers>

#include "geom/point.h"

namespace cocoon {

constexpr double degrees_per_radian = 180 / std::numbers::pi;
constexpr double radians_per_degree = std::numbers::pi / 180;

// Angle in [0, pi] at which the half planes from the edge through apex_a and through apex_b meet:
// the angle between the parts of apex_a - edge_from and apex_b - edge_from orthogonal to the edge.
// 0: one folded onto the other, pi: a smooth continuation. NaN if the edge has no length or an apex
// lies on its line, as far as floating point can tell. Symmetric in the apexes and, up to rounding,
// in the ends of the edge. Absolute error a few 2^-53 for well-shaped triangles: atan2 of both
// components, so no loss near 0 and pi.
// Source: the angle of Woo & Dey 2005 section 3.4 as its text and figures need it; see
// literal_dihedral for the printed equations.
double wedge_angle(const Point& edge_from, const Point& edge_to, const Point& apex_a,
                   const Point& apex_b);

// Woo & Dey 2005, Eq. 4-5 as printed, P0 = edge_from, P1 = edge_to, P2 = apex_a, P3 = apex_b:
//   (4) n_c = P0P1 x P0P2 / |.|,  n_k = P0P3 x P0P1 / |.|
//   (5) theta = arccos(n_c . n_k)
// The order of the factors in (4) orients both triangles alike, so theta is 0 for a smooth
// continuation: pi - wedge_angle. Kept for comparison only; nothing decides by it.
double literal_dihedral(const Point& edge_from, const Point& edge_to, const Point& apex_a,
                        const Point& apex_b);

}  // namespace cocoon
