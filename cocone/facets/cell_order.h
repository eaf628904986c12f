// The canonical order of cells and facets: by their corners as points, never by their numbers.
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "delaunay/triangulation.h"

namespace cocoon {

// Swaps two places if the second point comes first, and tells whether it did: by moving addresses,
// since a branch could not be foreseen.
inline bool order_places(const Point*& first, const Point*& second) {
  const bool swapped = *second < *first;
  const Point* const before = first;
  first = swapped ? second : first;
  second = swapped ? before : second;
  return swapped;
}

// Lexicographically; of a Triangulation or of a TriangulationView. Precondition: a finite facet.
// O(1).
template <class AnyTriangulation>
std::array<Point, 3> sorted_corners(const AnyTriangulation& triangulation, FacetId f) {
  const auto [u, v, w] = triangulation.facet_vertices(f);
  const Point* a = &triangulation.point(u);
  const Point* b = &triangulation.point(v);
  const Point* c = &triangulation.point(w);
  order_places(a, b);
  order_places(b, c);
  order_places(a, b);
  return {*a, *b, *c};
}

// Likewise. Precondition: a finite cell. O(1).
inline std::array<Point, 4> sorted_corners(const Triangulation& triangulation, CellId c) {
  const auto& vertices = triangulation.cell(c).vertices;
  const Point* p = &triangulation.point(vertices[0]);
  const Point* q = &triangulation.point(vertices[1]);
  const Point* r = &triangulation.point(vertices[2]);
  const Point* s = &triangulation.point(vertices[3]);
  order_places(p, q);
  order_places(r, s);
  order_places(p, r);
  order_places(q, s);
  order_places(q, r);
  return {*p, *q, *r, *s};
}

// Of finite cells, whatever their order. O(k log k) for k cells.
inline std::vector<std::array<Point, 4>> sorted_corners(const Triangulation& triangulation,
                                                        std::span<const CellId> cells) {
  std::vector<std::array<Point, 4>> corners;
  corners.reserve(cells.size());
  for (const CellId c : cells) corners.push_back(sorted_corners(triangulation, c));
  std::sort(corners.begin(), corners.end());
  return corners;
}

// Sets of finite cells: smaller ones first, then by their corners. O(k log k) for k cells each.
inline bool precedes(const Triangulation& triangulation, std::span<const CellId> a,
                     std::span<const CellId> b) {
  return a.size() != b.size() ? a.size() < b.size()
                              : sorted_corners(triangulation, a) < sorted_corners(triangulation, b);
}

}  // namespace cocoon
