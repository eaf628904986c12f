#include "cocone/facets/facet_size.h"

#include <limits>

#include "cocone/facets/cell_order.h"

namespace cocoon {

FacetSize size_of_triangle(const std::array<Point, 3>& p) {
  const Vec3 u = p[1] - p[0];
  const Vec3 v = p[2] - p[0];
  const double area = norm(cross(u, v));
  if (!(area > 0)) return {std::numeric_limits<double>::infinity(), p};
  return {squared_norm(u) / area * (squared_norm(v) / area) * squared_norm(u - v) / 4, p};
}

FacetSize size_of_facet(const TriangulationView& triangulation, FacetId f) {
  return size_of_triangle(sorted_corners(triangulation, f));
}

}  // namespace cocoon
