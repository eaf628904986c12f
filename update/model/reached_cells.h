// Which places are near given points, roughly and at once.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "geom/box.h"
#include "geom/point.h"

namespace cocoon {

// By how much computed points and distances may be off, as a share of the largest coordinate.
constexpr double rounding_slack = 0x1p-44;

// Of the corners of a box that is not empty, in any direction.
double largest_coordinate(const Box& box);

// A reach for ReachedCells that does not lose to rounding what is within this one of a center.
double reach_with_rounding(Points centers, double reach);

// Space in cells at least as wide as the reach, of which those within reach of a center are marked:
// what is within reach of one lies in a marked cell, what lies in one is not far from it.
class ReachedCells {
 public:
  // Finite centers, a finite reach that is not negative. Complexity: O(centers), and up to 2^18
  // cells.
  ReachedCells(Points centers, double reach);

  // The box of all marked cells.
  const Box& extent() const { return extent_; }

  // Whether the box has a point in a marked cell. Complexity: O(1) for a box no larger than a cell.
  bool overlap(const Box& box) const {
    return cocoon::overlap(box, extent_) &&
           !visit(box, [&](std::size_t cell) { return reached_[cell] == 0; });
  }

 private:
  // Calls visit(cell) for the cells that overlap the box until it returns false.
  template <class Visit>
  bool visit(const Box& box, const Visit& visit) const {
    std::array<std::size_t, 3> low;
    std::array<std::size_t, 3> high;
    for (int axis = 0; axis < 3; ++axis) {
      low[static_cast<std::size_t>(axis)] = cell_of(box.low, axis);
      high[static_cast<std::size_t>(axis)] = cell_of(box.high, axis);
    }
    for (std::size_t z = low[2]; z <= high[2]; ++z) {
      for (std::size_t y = low[1]; y <= high[1]; ++y) {
        for (std::size_t x = low[0]; x <= high[0]; ++x) {
          if (!visit((z * counts_[1] + y) * counts_[0] + x)) return false;
        }
      }
    }
    return true;
  }

  // Monotone in the coordinate, so that no rounding separates what overlaps.
  std::size_t cell_of(const Point& p, int axis) const {
    const auto i = static_cast<std::size_t>(axis);
    const double last = static_cast<double>(counts_[i] - 1);
    return static_cast<std::size_t>(
        std::clamp((p[axis] - extent_.low[axis]) * per_length_[i], 0.0, last));
  }

  Box extent_;
  std::array<std::size_t, 3> counts_{};
  std::array<double, 3> per_length_{};
  std::vector<std::uint8_t> reached_;
};

// All points within `reach` of a center, and some that are not much farther: few of many, so that a
// search tree over them alone answers for all. In their order. Finite points and centers, a finite
// reach that is not negative. Complexity: O(points + centers).
std::vector<Point> points_near(Points points, Points centers, double reach);

}  // namespace cocoon
