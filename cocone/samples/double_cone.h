// The double cone about a sample's normal, whose complement inside the Voronoi cell is the cocone.
//
// For x relative to the sample p and C = cos(theta): x lies in the upper nappe (above) if
// x . n > C |x|, in the lower one (below) if x . n < -C |x|, else in the cocone (closed). Both
// nappes of the open double cone are convex, so a segment with ends x and y meets the cocone unless
// both ends lie in the same nappe. Compared in squares: no root is taken. Complexity: O(1) each.
// Source: Amenta, Choi, Dey & Leekha 2002 (cocone); docs/stages/cocones.md.
#pragma once

#include <cstdint>

#include "geom/point.h"

namespace cocoon {

// Between these lengths squares of squares are in the range of double.
inline constexpr double largest_safe_length = 0x1p+250;
inline constexpr double smallest_safe_length = 0x1p-250;
// Longer vectors, as to the centers of slivers, and shorter ones are multiplied by these first.
inline constexpr double shrink = 0x1p-800;
inline constexpr double enlarge = 0x1p+800;

// Ordered from the negative to the positive side. The tangent plane divides `low` and `high`.
enum class ConeSide : std::uint8_t { below = 0, low = 1, high = 2, above = 3 };

namespace detail {

inline ConeSide cone_side_of_length(double along, double squared_length, double squared_cosine) {
  const bool in_nappe = along * along > squared_cosine * squared_length;
  if (along > 0) return in_nappe ? ConeSide::above : ConeSide::high;
  return in_nappe ? ConeSide::below : ConeSide::low;
}

}  // namespace detail

// Side of `x` (a point relative to the sample, or a direction) for the unit normal `n` and
// squared_cosine = C^2. Valid for every finite x; the zero vector is `low`.
inline ConeSide cone_side(const Vec3& x, const Vec3& n, double squared_cosine) {
  const double squared_length = squared_norm(x);
  if (squared_length < largest_safe_length * largest_safe_length &&
      squared_length > smallest_safe_length * smallest_safe_length) [[likely]] {
    return detail::cone_side_of_length(dot(x, n), squared_length, squared_cosine);
  }
  const double scale = squared_length > 1 ? shrink : enlarge;
  const Vec3 y = scale * x;
  return detail::cone_side_of_length(dot(y, n), squared_norm(y), squared_cosine);
}

inline bool in_cocone(ConeSide side) { return side == ConeSide::low || side == ConeSide::high; }

// True iff a segment (or ray) whose ends (or origin and direction) lie on these sides meets the
// cocone.
inline bool meets_cocone(ConeSide from, ConeSide to) { return from != to || in_cocone(from); }

}  // namespace cocoon
