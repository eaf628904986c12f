// Normals of facets with bits that do not depend on the order of corners or on the side.
#pragma once

#include "cocone/facets/cell_order.h"
#include "delaunay/triangulation.h"
#include "geom/point.h"

namespace cocoon {

// Points out of cell_of(f); its length is twice the area. From the other side the same bits with
// the other sign. Precondition: a finite facet. O(1).
inline Vec3 outward_normal(const Triangulation& triangulation, FacetId f) {
  const auto [u, v, w] = triangulation.facet_vertices(f);
  const Point* a = &triangulation.point(u);
  const Point* b = &triangulation.point(v);
  const Point* c = &triangulation.point(w);
  bool odd = order_places(a, b);
  odd ^= order_places(b, c);
  odd ^= order_places(a, b);
  return odd ? cross(*c - *a, *b - *a) : cross(*b - *a, *c - *a);
}

}  // namespace cocoon
