// Does a point lie inside the sphere through four others? Exact for all finite doubles, huge,
// tiny, subnormal and mixed. Levels as in geom/orient3d.h.
#pragma once

#include "geom/orient3d.h"

namespace cocoon {

// First level of insphere: |a|^2 [bcd] - |b|^2 [acd] + |c|^2 [abd] - |d|^2 [abc], all points
// relative to e and [pqr] = det[p; q; r], with the bound 385 u X Y Z L. X, Y, Z: largest
// |difference| on each axis, L: largest computed squared length, u = 2^-53.
//
// Derivation. Each of the 4 * 6 products of a squared length and three differences passes, per
// factor (1 + delta): 5 subtractions; 3 roundings of the squared length; 2 of the 2 x 2 minor; 3 of
// the 3 x 3 minor; 1 product; 2 additions: 16 in all. So |error| <= 24 ((1 + u)^16 - 1) XYZ L' with
// L' <= L (1 + u)^4 the true sum of squares: below 384.01 u XYZ L. The bound is rounded four times,
// (1 - u)^4 * 385 > 384.9. The rest pays for underflow: its absolute error is below 2^-60 u XYZ L
// if X, Y, Z >= 2^-190 (each product is then small only beside a large one). Overflow anywhere
// leaves value infinite or NaN, and then nothing is known.
inline constexpr double insphere_filter_coefficient = 385 * 0x1p-53;
inline constexpr double insphere_filter_smallest = 0x1p-190;

inline FilteredDeterminant insphere_filter(const Point& a, const Point& b, const Point& c,
                                           const Point& d, const Point& e) {
  const Vec3 p = a - e;
  const Vec3 q = b - e;
  const Vec3 r = c - e;
  const Vec3 s = d - e;
  const double pq = p.x * q.y - p.y * q.x;
  const double pr = p.x * r.y - p.y * r.x;
  const double ps = p.x * s.y - p.y * s.x;
  const double qr = q.x * r.y - q.y * r.x;
  const double qs = q.x * s.y - q.y * s.x;
  const double rs = r.x * s.y - r.y * s.x;
  const double pp = squared_norm(p);
  const double qq = squared_norm(q);
  const double rr = squared_norm(r);
  const double ss = squared_norm(s);
  const double value =
      (pp * (q.z * rs - r.z * qs + s.z * qr) - qq * (p.z * rs - r.z * ps + s.z * pr)) +
      (rr * (p.z * qs - q.z * ps + s.z * pq) - ss * (p.z * qr - q.z * pr + r.z * pq));
  const auto largest = [](double t, double u, double v, double w) {
    return std::max(std::max(t, u), std::max(v, w));
  };
  const double reach_x = largest(std::fabs(p.x), std::fabs(q.x), std::fabs(r.x), std::fabs(s.x));
  const double reach_y = largest(std::fabs(p.y), std::fabs(q.y), std::fabs(r.y), std::fabs(s.y));
  const double reach_z = largest(std::fabs(p.z), std::fabs(q.z), std::fabs(r.z), std::fabs(s.z));
  const bool in_range = std::min(std::min(reach_x, reach_y), reach_z) >= insphere_filter_smallest &&
                        std::fabs(value) <= std::numeric_limits<double>::max();
  const double product = (reach_x * reach_y * reach_z) * largest(pp, qq, rr, ss);
  const double infinity = std::numeric_limits<double>::infinity();
  return {value, in_range ? insphere_filter_coefficient * product : infinity, product};
}

// insphere where the first filter is not certain. Out of line: it is rare.
Sign insphere_after_filter(const Point& a, const Point& b, const Point& c, const Point& d,
                           const Point& e);

// For orient3d(a, b, c, d) > 0: positive iff e lies inside the sphere through a, b, c, d, zero iff
// on it, negative iff outside; for orient3d < 0 the opposite. Precondition: finite coordinates.
// Complexity: O(1).
inline Sign insphere(const Point& a, const Point& b, const Point& c, const Point& d,
                     const Point& e) {
  const FilteredDeterminant filter = insphere_filter(a, b, c, d, e);
  if (filter.value > filter.error) return Sign::positive;
  if (filter.value < -filter.error) return Sign::negative;
  return insphere_after_filter(a, b, c, d, e);
}

}  // namespace cocoon
