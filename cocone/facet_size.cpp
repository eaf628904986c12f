#include "cocone/facet_size.h"

#include <limits>

#include "cocone/cell_order.h"

namespace cocoon {

FacetSize size_of_facet(const Triangulation& triangulation, FacetId f) {
  const std::array<Point, 3> p = sorted_corners(triangulation, f);
  const Vec3 u = p[1] - p[0];
  const Vec3 v = p[2] - p[0];
  const double area = norm(cross(u, v));
  if (!(area > 0)) return {std::numeric_limits<double>::infinity(), p};
  return {squared_norm(u) / area * (squared_norm(v) / area) * squared_norm(u - v) / 4, p};
}

}  // namespace cocoon
