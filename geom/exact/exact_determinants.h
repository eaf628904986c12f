// The determinants of the predicates in exact integers, for the levels below the filters.
//
// Doubles are integers times a power of two. All coordinates of a call are put on one grid, whose
// unit is the lowest set bit among them; scaling by a power of two changes no sign. Then
// differences and products are integer arithmetic, free of overflow, underflow and rounding.
//
// Widths: with differences of K limbs and |difference| <= 2^(64K-2),
//   2 x 2 minor      <= 2 * 2^(128K-4)           = 2^(128K-3)    fits 2K limbs (< 2^(128K-1))
//   3 x 3 minor      <= 3 * 2^(64K-2 + 128K-3)   < 2^(192K-3)    fits 3K
//   squared length   <= 3 * 2^(128K-4)           < 2^(128K-2)    fits 2K
//   insphere         <= 4 * 2^(128K-2 + 192K-3)  = 2^(320K-3)    fits 5K
// so every sum below is exact. K = 1 serves grids and single-precision scans, K = 2 nearly all
// doubles of one scale, K = 33 every call with finite coordinates (2^1024 / 2^-1074 = 2^2098).
// Complexity: O(K^2) word products each, so O(1) for a given K.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "geom/exact/exact_integer.h"
#include "geom/point.h"

namespace cocoon {

template <std::size_t K>
using ExactVec3 = std::array<ExactInteger<K>, 3>;

template <std::size_t K>
ExactVec3<K> operator+(const ExactVec3<K>& p, const ExactVec3<K>& q) {
  return {p[0] + q[0], p[1] + q[1], p[2] + q[2]};
}

template <std::size_t K>
ExactVec3<K> operator-(const ExactVec3<K>& p, const ExactVec3<K>& q) {
  return {p[0] - q[0], p[1] - q[1], p[2] - q[2]};
}

template <std::size_t K>
ExactVec3<K> on_grid(const Point& p, int unit) {
  return {on_grid<K>(p.x, unit), on_grid<K>(p.y, unit), on_grid<K>(p.z, unit)};
}

// p - base in units of the grid.
template <std::size_t K>
ExactVec3<K> exact_difference(const Point& p, const Point& base, int unit) {
  return on_grid<K>(p, unit) - on_grid<K>(base, unit);
}

// p.x q.y - p.y q.x, and the same for any two axes.
template <std::size_t K>
ExactInteger<2 * K> exact_minor(const ExactVec3<K>& p, const ExactVec3<K>& q, std::size_t axis0 = 0,
                                std::size_t axis1 = 1) {
  return p[axis0] * q[axis1] - p[axis1] * q[axis0];
}

template <std::size_t A, std::size_t B>
ExactVec3<A + B> exact_cross(const ExactVec3<A>& p, const ExactVec3<B>& q) {
  return {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
}

template <std::size_t A, std::size_t B>
ExactInteger<A + B> exact_dot(const ExactVec3<A>& p, const ExactVec3<B>& q) {
  return p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
}

template <std::size_t A, std::size_t B>
ExactVec3<A + B> exact_scaled(const ExactInteger<A>& factor, const ExactVec3<B>& p) {
  return {factor * p[0], factor * p[1], factor * p[2]};
}

template <std::size_t K>
ExactInteger<2 * K> exact_squared_norm(const ExactVec3<K>& p) {
  return p[0] * p[0] + p[1] * p[1] + p[2] * p[2];
}

// det[p; q; r], given the minors of their x and y columns.
template <std::size_t K>
ExactInteger<3 * K> exact_determinant(const ExactVec3<K>& p, const ExactVec3<K>& q,
                                      const ExactVec3<K>& r, const ExactInteger<2 * K>& pq,
                                      const ExactInteger<2 * K>& pr,
                                      const ExactInteger<2 * K>& qr) {
  return p[2] * qr - q[2] * pr + r[2] * pq;
}

template <std::size_t K>
Sign exact_orient2d(const std::array<double, 6>& xy, int unit) {
  const auto difference = [&](std::size_t i, std::size_t j) {
    return on_grid<K>(xy[i], unit) - on_grid<K>(xy[j], unit);
  };
  return sign_of(difference(2, 0) * difference(5, 1) - difference(3, 1) * difference(4, 0));
}

// det[b - a; c - a; d - a].
template <std::size_t K>
Sign exact_orient3d(const std::array<Point, 4>& p, int unit) {
  const ExactVec3<K> base = on_grid<K>(p[0], unit);
  const ExactVec3<K> b = on_grid<K>(p[1], unit) - base;
  const ExactVec3<K> c = on_grid<K>(p[2], unit) - base;
  const ExactVec3<K> d = on_grid<K>(p[3], unit) - base;
  return sign_of(exact_determinant<K>(b, c, d, exact_minor<K>(b, c), exact_minor<K>(b, d),
                                      exact_minor<K>(c, d)));
}

// |a|^2 [bcd] - |b|^2 [acd] + |c|^2 [abd] - |d|^2 [abc], with all points relative to e.
template <std::size_t K>
Sign exact_insphere(const std::array<Point, 5>& p, int unit) {
  const ExactVec3<K> base = on_grid<K>(p[4], unit);
  const ExactVec3<K> a = on_grid<K>(p[0], unit) - base;
  const ExactVec3<K> b = on_grid<K>(p[1], unit) - base;
  const ExactVec3<K> c = on_grid<K>(p[2], unit) - base;
  const ExactVec3<K> d = on_grid<K>(p[3], unit) - base;
  const ExactInteger<2 * K> ab = exact_minor<K>(a, b);
  const ExactInteger<2 * K> ac = exact_minor<K>(a, c);
  const ExactInteger<2 * K> ad = exact_minor<K>(a, d);
  const ExactInteger<2 * K> bc = exact_minor<K>(b, c);
  const ExactInteger<2 * K> bd = exact_minor<K>(b, d);
  const ExactInteger<2 * K> cd = exact_minor<K>(c, d);
  return sign_of(exact_squared_norm<K>(a) * exact_determinant<K>(b, c, d, bc, bd, cd) -
                 exact_squared_norm<K>(b) * exact_determinant<K>(a, c, d, ac, ad, cd) +
                 exact_squared_norm<K>(c) * exact_determinant<K>(a, b, d, ab, ad, bd) -
                 exact_squared_norm<K>(d) * exact_determinant<K>(a, b, c, ab, ac, bc));
}

// The grid of a call: its unit, and the bits that its differences may need.
struct CommonGrid {
  int unit = 0;             // coordinates are integers times 2^unit
  int difference_bits = 0;  // |p - q| <= 2^(unit + difference_bits) on every axis
};

// `reach`: at least the largest |coordinate difference| of the call, up to one rounding (infinity
// if that overflows). All coordinates must be finite.
template <std::size_t N>
CommonGrid common_grid(const std::array<double, N>& coordinates, double reach) {
  int unit = 1024;
  for (const double value : coordinates) {
    const DyadicDouble parts = take_apart(value);
    if (parts.mantissa != 0 && parts.exponent < unit) unit = parts.exponent;
  }
  if (unit == 1024) return {0, 0};
  if (!std::isfinite(reach)) return {unit, 1026 - unit};
  // reach < 2^(ilogb + 1), and a rounding cannot carry the true difference beyond that power.
  return {unit, reach > 0 ? std::ilogb(reach) + 1 - unit : 0};
}

// What compute.operator()<K>() returns for the fewest limbs K of 1, 2, 4, 8 and 33 that hold the
// differences and are not below `fewest`.
template <class Compute>
auto in_fewest_limbs(const CommonGrid& grid, const Compute& compute, std::size_t fewest = 1) {
  if (fewest <= 1 && grid.difference_bits <= 62) return compute.template operator()<1>();
  if (fewest <= 2 && grid.difference_bits <= 126) return compute.template operator()<2>();
  if (fewest <= 4 && grid.difference_bits <= 254) return compute.template operator()<4>();
  if (fewest <= 8 && grid.difference_bits <= 510) return compute.template operator()<8>();
  return compute.template operator()<33>();
}

}  // namespace cocoon
