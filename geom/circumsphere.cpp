#include "geom/circumsphere.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

#include "geom/exact/exact_determinants.h"

namespace cocoon {

namespace {

// Allowed error of the numerator, against denominator * radius, and of the denominator, against
// itself. Together they leave center - a within 2^-23 radius on each axis, so that the distances to
// the vertices agree to sqrt(3) 2^-22 < 1e-6.
constexpr double error_share = 0x1p-24;
// Edges are scaled to about 1; denominators above this are out of reach of underflow.
constexpr double smallest_denominator = 0x1p-900;

// The power of two that brings `reach` to [1, 2): products of five lengths then stay in range.
double scale_for(double reach) {
  // The biased exponent of 2^-e is 2046 minus that of a normal reach in [2^e, 2^(e+1)).
  const std::uint64_t biased = std::bit_cast<std::uint64_t>(reach) >> 52;
  if (biased >= 1 && biased <= 2045) return std::bit_cast<double>((2046 - biased) << 52);
  return std::ldexp(1.0, -std::clamp(std::ilogb(reach), -1022, 1022));
}

// Sorts by few comparisons, in place of the general sort of a range of unknown length.
template <std::size_t N>
void sort_lexicographically(std::array<Point, N>& p) {
  for (std::size_t i = 1; i < N; ++i) {
    for (std::size_t k = i; k > 0 && p[k] < p[k - 1]; --k) std::swap(p[k], p[k - 1]);
  }
}

// The sums of |products| behind the components of cross(p, q).
Vec3 absolute_cross(const Vec3& p, const Vec3& q) {
  return {std::fabs(p.y * q.z) + std::fabs(p.z * q.y), std::fabs(p.z * q.x) + std::fabs(p.x * q.z),
          std::fabs(p.x * q.y) + std::fabs(p.y * q.x)};
}

Vec3 absolute(const Vec3& p) { return {std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)}; }

std::optional<Point> finite_sum(const Point& base, const Vec3& offset) {
  const Point sum = base + offset;
  if (!is_finite(sum)) return std::nullopt;
  return sum;
}

// Level `doubles`. p is in lexicographic order. Products pass 8 roundings on their way into the
// denominator, as in orient3d_filter, and 12 into the numerator: 4 differences, 3 of the squared
// length, 2 of the cross product, 1 product, 2 sums. Hence 9 u and 13 u of their absolute sums.
std::optional<Point> tetrahedron_in_doubles(const std::array<Point, 4>& p, double reach) {
  if (!(reach > 0) || !std::isfinite(reach)) return std::nullopt;
  const double scale = scale_for(reach);
  const Vec3 u = scale * (p[1] - p[0]);
  const Vec3 v = scale * (p[2] - p[0]);
  const Vec3 w = scale * (p[3] - p[0]);
  const double uu = squared_norm(u);
  const double vv = squared_norm(v);
  const double ww = squared_norm(w);
  const Vec3 vw = cross(v, w);
  const double denominator = 2 * dot(u, vw);
  const Vec3 offset = (uu * vw + vv * cross(w, u) + ww * cross(u, v)) / denominator;

  const Vec3 vw_sum = absolute_cross(v, w);
  const double denominator_sum = 2 * dot(absolute(u), vw_sum);
  const double numerator_sum =
      max_norm(uu * vw_sum + vv * absolute_cross(w, u) + ww * absolute_cross(u, v));
  const double allowed = error_share * std::fabs(denominator);
  const bool certain = std::fabs(denominator) > smallest_denominator &&
                       9 * 0x1p-53 * denominator_sum <= allowed &&
                       13 * 0x1p-53 * numerator_sum <= allowed * norm(offset);
  if (!certain) return std::nullopt;
  return finite_sum(p[0], (1 / scale) * offset);
}

// Level `doubles` of a triangle. 14 roundings into the numerator: 5 differences, 3 of the squared
// length, 2 of n, 2 of the cross product, 1 product, 1 sum. The denominator is relatively twice as
// uncertain as n, whose components carry 5 u of their absolute sums.
std::optional<Point> triangle_in_doubles(const std::array<Point, 3>& p, double reach) {
  if (!(reach > 0) || !std::isfinite(reach)) return std::nullopt;
  const double scale = scale_for(reach);
  const Vec3 u = scale * (p[1] - p[0]);
  const Vec3 v = scale * (p[2] - p[0]);
  const double uu = squared_norm(u);
  const double vv = squared_norm(v);
  const Vec3 n = cross(u, v);
  const double denominator = 2 * squared_norm(n);
  const Vec3 offset = (vv * cross(n, u) - uu * cross(n, v)) / denominator;

  const Vec3 n_sum = absolute_cross(u, v);
  const double numerator_sum =
      max_norm(vv * absolute_cross(n_sum, u) + uu * absolute_cross(n_sum, v));
  const double allowed = error_share * denominator;
  const bool certain = denominator > smallest_denominator &&
                       2 * 6 * 0x1p-53 * norm(n_sum) <= error_share * norm(n) &&
                       15 * 0x1p-53 * numerator_sum <= allowed * norm(offset);
  if (!certain) return std::nullopt;
  return finite_sum(p[0], (1 / scale) * offset);
}

template <std::size_t A, std::size_t B>
Vec3 rounded_quotients(const ExactVec3<A>& numerator, const ExactInteger<B>& denominator,
                       int exponent) {
  const ScaledDouble d = rounded(denominator);
  const auto quotient = [&](const ExactInteger<A>& integer) {
    const ScaledDouble n = rounded(integer);
    return std::ldexp(n.value / d.value, n.exponent - d.exponent + exponent);
  };
  return {quotient(numerator[0]), quotient(numerator[1]), quotient(numerator[2])};
}

template <std::size_t K>
struct ExactCenter {
  // By the widths of exact_determinants.h: numerator < 3 * 2^(256K-5), so 4K limbs.
  static std::optional<Point> of(const std::array<Point, 4>& p, int unit) {
    const ExactVec3<K> u = exact_difference<K>(p[1], p[0], unit);
    const ExactVec3<K> v = exact_difference<K>(p[2], p[0], unit);
    const ExactVec3<K> w = exact_difference<K>(p[3], p[0], unit);
    const ExactVec3<2 * K> vw = exact_cross(v, w);
    const ExactInteger<3 * K> denominator = exact_dot(u, vw);
    if (sign_of(denominator) == Sign::zero) return std::nullopt;
    const ExactVec3<4 * K> numerator = exact_scaled(exact_squared_norm<K>(u), vw) +
                                       exact_scaled(exact_squared_norm<K>(v), exact_cross(w, u)) +
                                       exact_scaled(exact_squared_norm<K>(w), exact_cross(u, v));
    return finite_sum(p[0], rounded_quotients(numerator, denominator, unit - 1));
  }

  // |n x u| <= 2^(192K-4) on every axis, so the numerator < 2^(320K-5): 5K limbs.
  static std::optional<Point> of(const std::array<Point, 3>& p, int unit) {
    const ExactVec3<K> u = exact_difference<K>(p[1], p[0], unit);
    const ExactVec3<K> v = exact_difference<K>(p[2], p[0], unit);
    const ExactVec3<2 * K> n = exact_cross(u, v);
    const ExactInteger<4 * K> denominator = exact_squared_norm<2 * K>(n);
    if (sign_of(denominator) == Sign::zero) return std::nullopt;
    const ExactVec3<5 * K> numerator = exact_scaled(exact_squared_norm<K>(v), exact_cross(n, u)) -
                                       exact_scaled(exact_squared_norm<K>(u), exact_cross(n, v));
    return finite_sum(p[0], rounded_quotients(numerator, denominator, unit - 1));
  }
};

// Level `exact`. Nothing if the simplex is flat or its center overflows.
template <std::size_t N>
std::optional<Point> center_in_integers(const std::array<Point, N>& p, double reach) {
  std::array<double, 3 * N> coordinates;
  for (std::size_t i = 0; i < N; ++i) {
    coordinates[3 * i] = p[i].x;
    coordinates[3 * i + 1] = p[i].y;
    coordinates[3 * i + 2] = p[i].z;
  }
  const CommonGrid grid = common_grid(coordinates, reach);
  return in_fewest_limbs(grid, [&]<std::size_t K>() { return ExactCenter<K>::of(p, grid.unit); });
}

template <std::size_t N>
double reach_from_first(const std::array<Point, N>& p) {
  double reach = 0;
  for (std::size_t i = 1; i < N; ++i) reach = std::max(reach, max_norm(p[i] - p[0]));
  return reach;
}

// Divides before it adds: no overflow.
template <std::size_t N>
Circumcenter centroid(const std::array<Point, N>& p) {
  Point sum = p[0] / double{N};
  for (std::size_t i = 1; i < N; ++i) sum = sum + p[i] / double{N};
  return {sum, CenterLevel::centroid};
}

}  // namespace

Circumcenter circumcenter(const Point& a, const Point& b, const Point& c) {
  std::array<Point, 3> p = {a, b, c};
  sort_lexicographically(p);
  const double reach = reach_from_first(p);
  if (const auto center = triangle_in_doubles(p, reach)) return {*center, CenterLevel::doubles};
  if (const auto center = center_in_integers(p, reach)) return {*center, CenterLevel::exact};
  return centroid(p);
}

Circumcenter circumcenter(const Point& a, const Point& b, const Point& c, const Point& d) {
  std::array<Point, 4> p = {a, b, c, d};
  sort_lexicographically(p);
  const double reach = reach_from_first(p);
  if (const auto center = tetrahedron_in_doubles(p, reach)) return {*center, CenterLevel::doubles};
  if (const auto center = center_in_integers(p, reach)) return {*center, CenterLevel::exact};
  constexpr std::array<std::array<std::size_t, 3>, 4> facets = {
      {{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}}};
  for (const auto& [i, j, k] : facets) {
    const Circumcenter facet = circumcenter(p[i], p[j], p[k]);
    if (facet.level != CenterLevel::centroid) return {facet.center, CenterLevel::facet};
  }
  return centroid(p);
}

}  // namespace cocoon
