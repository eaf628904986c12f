#include "geom/triangle_normal.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include "geom/exact/exact_determinants.h"
#include "geom/scaled_to_one.h"

namespace cocoon {
namespace {

using Corners = std::array<Point, 3>;

constexpr double largest_relative_error = 1e-6;

double reach_from_first(const Corners& p) {
  return std::max(max_norm(p[1] - p[0]), max_norm(p[2] - p[0]));
}

// Each coordinate of u x v is a difference of two products of rounded differences: off by less than
// 8 roundings of products that are below 4. So |error| < sqrt(3) * 8 * 4 * 2^-53 < 56 * 2^-53.
std::optional<Vec3> normal_in_doubles(const Corners& p) {
  const Vec3 u = p[1] - p[0];
  const Vec3 v = p[2] - p[0];
  if (!(max_norm(u) > 0) || !(max_norm(v) > 0)) return std::nullopt;
  if (!std::isfinite(max_norm(u)) || !std::isfinite(max_norm(v))) return std::nullopt;
  // Brought to one, the product keeps its direction, and cannot overflow or vanish by underflow.
  const Vec3 normal = cross(scaled_to_one(u), scaled_to_one(v));
  const double length = norm(normal);
  if (!(length * largest_relative_error > 56 * 0x1p-53)) return std::nullopt;
  return normal / length;
}

// K limbs hold the differences, so 2K the coordinates of the cross product; brought to doubles with
// a common exponent.
template <std::size_t K>
Vec3 normal_in_integers(const Corners& p, int grid_unit) {
  const ExactVec3<2 * K> normal = exact_cross(exact_difference<K>(p[1], p[0], grid_unit),
                                              exact_difference<K>(p[2], p[0], grid_unit));
  const std::array<ScaledDouble, 3> parts = {rounded(normal[0]), rounded(normal[1]),
                                             rounded(normal[2])};
  int highest = -1;
  for (const ScaledDouble& part : parts) {
    if (part.value != 0) highest = std::max(highest, part.exponent);
  }
  const auto coordinate = [&](const ScaledDouble& part) {
    return part.value == 0 ? 0 : std::ldexp(part.value, part.exponent - highest);
  };
  return unit({coordinate(parts[0]), coordinate(parts[1]), coordinate(parts[2])});
}

Vec3 exact_normal(const Corners& p) {
  const CommonGrid grid =
      common_grid<9>({p[0].x, p[0].y, p[0].z, p[1].x, p[1].y, p[1].z, p[2].x, p[2].y, p[2].z},
                     reach_from_first(p));
  return in_fewest_limbs(grid,
                         [&]<std::size_t K>() { return normal_in_integers<K>(p, grid.unit); });
}

// Sorts the corners; returns true if that was an odd permutation, which turns the normal over.
bool sort_corners(Corners& p) {
  bool odd = false;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = i + 1; j < 3; ++j) odd ^= p[j] < p[i];
  }
  std::sort(p.begin(), p.end());
  return odd;
}

}  // namespace

TriangleNormal triangle_normal(const Point& a, const Point& b, const Point& c) {
  Corners p = {a, b, c};
  const bool odd = sort_corners(p);
  TriangleNormal result;
  if (const std::optional<Vec3> direction = normal_in_doubles(p)) {
    result.direction = *direction;
  } else {
    result = {exact_normal(p), true};
  }
  if (odd) result.direction = -result.direction;
  return result;
}

}  // namespace cocoon
