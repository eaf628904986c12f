#include "geom/working_scale.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <string>

#include "geom/errors.h"
#include "geom/messages/place_name.h"
#include "geom/parallel/parallel_reduce.h"

namespace cocoon {
namespace {

constexpr double largest_coordinate = 0x1p+100;
constexpr double smallest_coordinate = 0x1p-100;
constexpr double largest_ratio = 0x1p+200;

double largest_coordinate_of(Points points, const Execution& execution) {
  const auto largest_of = [&](std::size_t begin, std::size_t end) {
    double largest = 0;
    for (const Point& p : points.subspan(begin, end - begin)) {
      largest = std::max(largest, max_norm(p));
    }
    return largest;
  };
  return parallel_reduce(execution, points.size(), 0.0, largest_of,
                         [](double a, double b) { return std::max(a, b); });
}

double scale_of(double largest) {
  const bool in_bounds = largest >= smallest_coordinate && largest <= largest_coordinate;
  if (in_bounds || largest == 0 || !std::isfinite(largest)) return 1;
  return std::ldexp(1.0, std::clamp(-std::ilogb(largest), -1022, 1022));
}

}  // namespace

double working_scale(Points points, const Execution& execution) {
  return scale_of(largest_coordinate_of(points, execution));
}

double common_scale(Points a, Points b) {
  constexpr double large = 0x1p+200;
  const double scale =
      scale_of(std::max(largest_coordinate_of(a, {}), largest_coordinate_of(b, {})));
  return scale < 1 ? large * scale : scale;
}

void require_comparable_sizes(Points points, const Execution& execution) {
  const double largest = largest_coordinate_of(points, execution);
  if (!std::isfinite(largest)) return;  // an infinite one is no far point
  const double far = largest / largest_ratio;
  const auto count = [&](const auto& counts) {
    return parallel_reduce(
        execution, points.size(), std::size_t{0},
        [&](std::size_t begin, std::size_t end) {
          const Points part = points.subspan(begin, end - begin);
          return static_cast<std::size_t>(std::count_if(part.begin(), part.end(), counts));
        },
        std::plus<>());
  };
  const std::size_t near =
      count([far](const Point& p) { return max_norm(p) > 0 && max_norm(p) < far; });
  if (near == 0) return;  // mostly so: one pass less
  const std::size_t others = count([far](const Point& p) { return max_norm(p) >= far; });
  if (near <= others) return;
  const auto farthest = std::find_if(points.begin(), points.end(),
                                     [&](const Point& p) { return max_norm(p) == largest; });
  throw InputError("point " + std::to_string(farthest - points.begin()) + " at " +
                   place_name(*farthest) +
                   " is more than 2^200 (1.6e60) times as far out as most others, whose squared "
                   "areas vanish beside it; remove " +
                   (others == 1 ? "it" : "the " + std::to_string(others) + " points far out") +
                   " or filter outliers first");
}

bool scales_exactly(Points points, double scale) {
  return std::all_of(points.begin(), points.end(), [&](const Point& p) {
    const Point scaled = scale * p;
    return is_finite(scaled) && scaled / scale == p;
  });
}

std::vector<Point> scaled(Points points, double factor) {
  std::vector<Point> copy(points.begin(), points.end());
  for (Point& p : copy) p = factor * p;
  return copy;
}

TriangleMesh scaled(TriangleMesh mesh, double factor) {
  for (Point& p : mesh.points) p = factor * p;
  return mesh;
}

}  // namespace cocoon
