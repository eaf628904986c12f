#include "geom/off_plane.h"

#include <algorithm>
#include <cstdint>

#include "geom/box.h"
#include "geom/orient3d.h"
#include "geom/search/point_hash.h"
#include "geom/sign.h"
#include "geom/working_scale.h"

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

// From three points that are far apart, chosen whatever the order of the points; these times
// `scale` have working size.
Vec3 normal_of(Points points, double scale) {
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
  const auto way_to = [&](const Point& p) { return scale * p - scale * first; };
  const Point second = farthest([&](const Point& p) { return norm(way_to(p)); });
  const Vec3 along = way_to(second);
  const Point third = farthest([&](const Point& p) { return norm(cross(along, way_to(p))); });
  return unit(cross(along, way_to(third)));
}

// In [-1, 1].
double random_share(const Point& p) {
  return static_cast<double>(static_cast<std::int64_t>(point_hash(p))) * 0x1p-63;
}

}  // namespace

std::vector<Point> moved_off_plane(Points points, const OffPlaneOptions& options) {
  // Hundreds of roundings of a coordinate: far from the origin less might move nothing.
  constexpr double least_share_of_coordinate = 0x1p-44;
  if (!are_flat(points)) return {};
  const double scale = working_scale(points);
  const Box box = box_of(points);
  const double extent = max_norm(scale * box.high - scale * box.low);
  const double coordinate = scale * std::max(max_norm(box.low), max_norm(box.high));
  const double reach = std::max(options.share * extent, least_share_of_coordinate * coordinate);
  const Vec3 step = (reach * normal_of(points, scale)) / scale;
  std::vector<Point> moved;
  moved.reserve(points.size());
  for (const Point& p : points) moved.push_back(p + random_share(p) * step);
  return moved;
}

}  // namespace cocoon
