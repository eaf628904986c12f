#include "geom/off_plane.h"

#include <algorithm>
#include <cstdint>

#include "geom/box.h"
#include "geom/orient3d.h"
#include "geom/point_hash.h"
#include "geom/sign.h"

namespace cocoon {
namespace {

// Exactly; looks no farther than the first point that tells.
bool are_flat(Points points) {
  const Point* second = nullptr;
  const Point* third = nullptr;
  for (const Point& p : points) {
    if (!is_finite(p)) return false;
    if (second == nullptr) {
      if (p != points[0]) second = &p;
    } else if (third == nullptr) {
      if (!are_collinear(points[0], *second, p)) third = &p;
    } else if (orient3d(points[0], *second, *third, p) != Sign::zero) {
      return false;
    }
  }
  return third != nullptr;
}

// From three points that are far apart, chosen whatever the order of the points.
Vec3 normal_of(Points points) {
  const Point first = *std::min_element(points.begin(), points.end(),
                                        [](const auto& a, const auto& b) { return (a <=> b) < 0; });
  const auto farthest = [&](const auto& measure) {
    Point best = first;
    for (const Point& p : points) {
      const double more = measure(p) - measure(best);
      if (more > 0 || (more == 0 && (p <=> best) < 0)) best = p;
    }
    return best;
  };
  const Point second = farthest([&](const Point& p) { return norm(p - first); });
  const Point third =
      farthest([&](const Point& p) { return norm(cross(second - first, p - first)); });
  return unit(cross(second - first, third - first));
}

// In [-1, 1).
double random_share(const Point& p) {
  return static_cast<double>(static_cast<std::int64_t>(point_hash(p))) * 0x1p-63;
}

}  // namespace

std::vector<Point> moved_off_plane(Points points, const OffPlaneOptions& options) {
  if (!are_flat(points)) return {};
  const Vec3 step = options.share * max_norm(box_of(points).size()) * normal_of(points);
  std::vector<Point> moved;
  moved.reserve(points.size());
  for (const Point& p : points) moved.push_back(p + random_share(p) * step);
  return moved;
}

}  // namespace cocoon
