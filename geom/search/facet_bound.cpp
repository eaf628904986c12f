#include "geom/search/facet_bound.h"

#include "geom/triangle_normal.h"

namespace cocoon {

FacetBound::FacetBound(const TrianglePoints& corners) {
  // Roundings of coordinates enter distances through the normal, which is off by as much more as
  // the triangle is narrow: a few hundred times the rounding of one addition, or some of that.
  constexpr double rounding_per_coordinate = 0x1p-44;
  constexpr double narrow = 64;
  constexpr double too_narrow = 0x1p26;
  const Vec3 area = area_normal(corners[0], corners[1], corners[2]);
  double squared_edge = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    squared_edge = std::max(squared_edge, squared_norm(corners[(i + 1) % 3] - corners[i]));
    largest_ = std::max(largest_, max_norm(corners[i]));
  }
  const double narrowness = squared_edge / norm(area);
  if (!(narrowness < too_narrow)) return;
  rounding_ = rounding_per_coordinate * std::max(narrowness / narrow, 1.0);
  const Vec3 normal = unit(area);
  for (std::size_t k = 0; k < 4; ++k) {
    const Point& from = corners[k % 3];
    const Vec3 direction = k < 3 ? unit(cross(corners[(k + 1) % 3] - from, normal)) : normal;
    const std::size_t at = (k + 1) % 4;  // the plane's comes first
    x_[at] = direction.x;
    y_[at] = direction.y;
    z_[at] = direction.z;
    offset_[at] = dot(direction, from);
  }
}

}  // namespace cocoon
