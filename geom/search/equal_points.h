// Which of a list of points are equal, and the list without these.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "geom/point.h"

namespace cocoon {

// A point that is equal to an earlier one (0 and -0 are), and the first of those; positions.
struct RepeatedPoint {
  std::uint32_t point;
  std::uint32_t first;

  friend bool operator==(const RepeatedPoint&, const RepeatedPoint&) = default;
};

// All of them, in increasing order. The first `distinct` points are known to differ from each
// other: the hashes are those of the others. Precondition: finite points, fewer than 2^32.
// Complexity: O(n), two passes over the points, and k log k for k points that are equal or look so
// to a table of at least 16 bits per point (up to n / 16 of those that differ). Deterministic.
std::vector<RepeatedPoint> repeated_points(Points points, std::size_t distinct = 0);

// Overload for callers that know which of the `distinct` lie in the bounding box of the others:
// `near`, ascending. Complexity: O(m + k log k) for m points that are others or near.
std::vector<RepeatedPoint> repeated_points(Points points, std::size_t distinct,
                                           std::span<const std::uint32_t> near);

// The points without equal ones, in lexicographic order. Precondition: finite points. Complexity:
// O(n log n).
std::vector<Point> distinct_points(Points points);

}  // namespace cocoon
