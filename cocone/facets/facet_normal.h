// Normals of facets with bits that do not depend on the order of corners or on the side.
#pragma once

#include <array>
#include <utility>

#include "delaunay/triangulation.h"
#include "geom/point.h"

namespace cocoon {

// Points out of cell_of(f); its length is twice the area. From the other side the same bits with
// the other sign. Precondition: a finite facet. O(1).
inline Vec3 outward_normal(const Triangulation& triangulation, FacetId f) {
  const std::array<VertexId, 3> vertices = triangulation.facet_vertices(f);
  std::array<Point, 3> p;
  for (std::size_t i = 0; i < 3; ++i) p[i] = triangulation.point(vertices[i]);
  bool odd = false;
  const auto order = [&](std::size_t i, std::size_t j) {
    if (!(p[j] < p[i])) return;
    std::swap(p[i], p[j]);
    odd = !odd;
  };
  order(0, 1);
  order(1, 2);
  order(0, 1);
  return odd ? cross(p[2] - p[0], p[1] - p[0]) : cross(p[1] - p[0], p[2] - p[0]);
}

}  // namespace cocoon
