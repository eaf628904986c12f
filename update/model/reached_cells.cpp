#include "update/model/reached_cells.h"

#include <cmath>

namespace cocoon {
namespace {

constexpr double max_cells = 64;  // along each axis

}  // namespace

double largest_coordinate(const Box& box) {
  return std::max(max_norm(box.low), max_norm(box.high));
}

double reach_with_rounding(Points centers, double reach) {
  return reach + rounding_slack * (largest_coordinate(box_of(centers)) + 4 * reach);
}

ReachedCells::ReachedCells(Points centers, double reach) : extent_(box_of(centers)) {
  extent_.enlarge(reach);
  const Vec3 size = extent_.size();
  for (int axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    const double cells =
        size[axis] > reach ? std::clamp(std::floor(size[axis] / reach), 1.0, max_cells) : 1;
    const double per_length = cells / size[axis];
    const bool has_width = size[axis] > 0 && std::isfinite(per_length);  // infinite: subnormal
    counts_[i] = has_width ? static_cast<std::size_t>(cells) : 1;
    per_length_[i] = has_width ? per_length : 0;
  }
  reached_.assign(counts_[0] * counts_[1] * counts_[2], 0);
  for (const Point& p : centers) {
    Box box;
    box.include(p);
    box.enlarge(reach);
    visit(box, [&](std::size_t cell) {
      reached_[cell] = 1;
      return true;
    });
  }
}

std::vector<Point> points_near(Points points, Points centers, double reach) {
  std::vector<Point> near;
  if (centers.empty()) return near;
  const double with_rounding = reach_with_rounding(centers, reach);
  if (!std::isfinite(with_rounding)) return {points.begin(), points.end()};
  const ReachedCells cells(centers, with_rounding);
  for (const Point& p : points) {
    if (cells.overlap(Box{p, p})) near.push_back(p);
  }
  return near;
}

}  // namespace cocoon
