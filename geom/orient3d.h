// On which side of a plane, or of a line, does a point lie? Exact for all finite doubles, huge,
// tiny, subnormal and mixed.
//
// Levels (geom/exact/predicate_levels.h names them for the tests): the filter below, inline; a
// tighter filter; integers. See docs/stages/predicates.md.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "geom/point.h"
#include "geom/sign.h"

namespace cocoon {

// A determinant in floating point: |true value - value| <= error, infinity if nothing is known.
struct FilteredDeterminant {
  double value = 0;
  double error = std::numeric_limits<double>::infinity();
  double product = error;  // the product of extents that `error` is a multiple of

  bool is_certain() const { return value > error || value < -error; }
};

// First level of orient3d: its determinant with the bound 49 u X Y Z, where X, Y, Z are the largest
// |difference| on each axis and u = 2^-53.
//
// Derivation. Each of the 6 products of three differences is at most XYZ and passes 3 subtractions,
// 2 multiplications and at most 3 additions, each a factor (1 + delta) with |delta| <= u: 8 in all,
// so |error| <= 6 ((1 + u)^8 - 1) XYZ < 48.01 u XYZ. The bound itself is rounded three times,
// (1 - u)^3 * 49 > 48.9. The rest, 0.8 u XYZ, pays for underflow, which is possible in products
// only: absolute error <= 6 * 2^-1075 max(X, Y, Z) + 3 * 2^-1075, far below u XYZ if X, Y, Z are at
// least 2^-320. Overflow anywhere leaves value infinite or NaN, and then nothing is known.
inline FilteredDeterminant orient3d_filter(const Point& a, const Point& b, const Point& c,
                                           const Point& d) {
  constexpr double coefficient = 49 * 0x1p-53;
  constexpr double smallest = 0x1p-320;
  const Vec3 p = b - a;
  const Vec3 q = c - a;
  const Vec3 r = d - a;
  const double value =
      p.x * (q.y * r.z - q.z * r.y) + p.y * (q.z * r.x - q.x * r.z) + p.z * (q.x * r.y - q.y * r.x);
  const double reach_x = std::max(std::max(std::fabs(p.x), std::fabs(q.x)), std::fabs(r.x));
  const double reach_y = std::max(std::max(std::fabs(p.y), std::fabs(q.y)), std::fabs(r.y));
  const double reach_z = std::max(std::max(std::fabs(p.z), std::fabs(q.z)), std::fabs(r.z));
  const bool in_range = std::min(std::min(reach_x, reach_y), reach_z) >= smallest &&
                        std::fabs(value) <= std::numeric_limits<double>::max();
  if (!in_range) return {value};
  return {value, coefficient * (reach_x * reach_y * reach_z)};
}

// orient3d where the first filter is not certain. Out of line: it is rare.
Sign orient3d_after_filter(const Point& a, const Point& b, const Point& c, const Point& d);

// Sign of det[b - a; c - a; d - a]: positive iff d lies on the side of the plane abc to which the
// normal (b - a) x (c - a) points, zero iff the four points are coplanar.
// Precondition: finite coordinates. Complexity: O(1).
inline Sign orient3d(const Point& a, const Point& b, const Point& c, const Point& d) {
  const FilteredDeterminant filter = orient3d_filter(a, b, c, d);
  if (filter.value > filter.error) return Sign::positive;
  if (filter.value < -filter.error) return Sign::negative;
  return orient3d_after_filter(a, b, c, d);
}

// Sign of (b - a) x (c - a) in the plane, given by the two coordinates (x, y) of each point.
// Precondition: finite coordinates. Complexity: O(1).
Sign orient2d(double ax, double ay, double bx, double by, double cx, double cy);

// True iff the three points of space lie on one line (exact: all three projections do).
bool are_collinear(const Point& a, const Point& b, const Point& c);

}  // namespace cocoon
