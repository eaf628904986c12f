#include "geom/working_scale.h"

#include <algorithm>
#include <cmath>

#include "geom/parallel_reduce.h"

namespace cocoon {
namespace {

constexpr double largest_coordinate = 0x1p+100;
constexpr double smallest_coordinate = 0x1p-100;

}  // namespace

double working_scale(Points points, const Execution& execution) {
  const auto largest_of = [&](std::size_t begin, std::size_t end) {
    double largest = 0;
    for (const Point& p : points.subspan(begin, end - begin)) {
      largest = std::max(largest, max_norm(p));
    }
    return largest;
  };
  const double largest = parallel_reduce(execution, points.size(), 0.0, largest_of,
                                         [](double a, double b) { return std::max(a, b); });
  const bool in_bounds = largest >= smallest_coordinate && largest <= largest_coordinate;
  if (in_bounds || largest == 0 || !std::isfinite(largest)) return 1;
  return std::ldexp(1.0, std::clamp(-std::ilogb(largest), -1022, 1022));
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
