// Points of which no two are closer to each other than a given distance, as samples of a scan.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <vector>

#include "geom/point.h"

namespace cocoon::testing {

class SpreadPoints {
 public:
  explicit SpreadPoints(double least) : least_(least) {}

  // Unless one is closer already.
  void add(const Point& p) {
    if (!is_free(p)) return;
    grid_[cell_of(p)].push_back(p);
    points_.push_back(p);
  }
  const std::vector<Point>& points() const { return points_; }

 private:
  using Cell = std::array<std::int64_t, 3>;
  Cell cell_of(const Point& p) const {
    return {static_cast<std::int64_t>(std::floor(p.x / least_)),
            static_cast<std::int64_t>(std::floor(p.y / least_)),
            static_cast<std::int64_t>(std::floor(p.z / least_))};
  }
  bool is_free(const Point& p) const {
    const auto [x, y, z] = cell_of(p);
    for (std::int64_t i = 0; i < 27; ++i) {
      const auto cell = grid_.find({x + i % 3 - 1, y + i / 3 % 3 - 1, z + i / 9 - 1});
      if (cell == grid_.end()) continue;
      for (const Point& q : cell->second) {
        if (distance(p, q) < least_) return false;
      }
    }
    return true;
  }

  double least_;
  std::map<Cell, std::vector<Point>> grid_;
  std::vector<Point> points_;
};

}  // namespace cocoon::testing
