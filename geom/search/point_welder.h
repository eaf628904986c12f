// Finds equal points while they arrive one by one. (equal_points.h finds those of a list.)
#pragma once

#include <cstddef>
#include <vector>

#include "geom/point.h"

namespace cocoon {

// Appends to `points` what is not in it yet. Points are equal if their coordinates are (-0 = 0, as
// everywhere); the bits of the first one stay. Points that are not finite equal none: they would
// all come to the same place of the table. An open-addressing table: O(1) expected per point.
class PointWelder {
 public:
  // `points` must outlive this object, and only this object may change it.
  explicit PointWelder(std::vector<Point>& points) : points_(points), table_(1024, none) {}

  // A copy would write to the points of this one.
  PointWelder(const PointWelder&) = delete;
  PointWelder& operator=(const PointWelder&) = delete;

  // The position in `points` of a point equal to `point`, the last one if that is new.
  std::size_t add(const Point& point);

  static constexpr std::size_t none = ~std::size_t{0};
  // The same of points that have been added; else none.
  std::size_t find(const Point& point) const;

 private:
  std::size_t slot_of(const Point& point) const;
  void grow();

  std::vector<Point>& points_;
  std::vector<std::size_t> table_;  // power of two many slots, at most half of them used
};

}  // namespace cocoon
