#include "cocone/facet_size.h"

#include <algorithm>
#include <limits>

namespace cocoon {

FacetSize size_of_facet(const Triangulation& triangulation, FacetId f) {
  const auto [a, b, c] = triangulation.facet_vertices(f);
  std::array<Point, 3> p{triangulation.point(a), triangulation.point(b), triangulation.point(c)};
  std::sort(p.begin(), p.end());
  const Vec3 u = p[1] - p[0];
  const Vec3 v = p[2] - p[0];
  const double area = norm(cross(u, v));
  if (!(area > 0)) return {std::numeric_limits<double>::infinity(), p};
  return {squared_norm(u) / area * (squared_norm(v) / area) * squared_norm(u - v) / 4, p};
}

}  // namespace cocoon
