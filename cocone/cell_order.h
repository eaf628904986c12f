// The canonical order of cells and facets: by their corners as points, never by their numbers.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "delaunay/triangulation.h"

namespace cocoon {

// Lexicographically; of a Triangulation or of a TriangulationView. Precondition: a finite facet.
// O(1).
template <class AnyTriangulation>
std::array<Point, 3> sorted_corners(const AnyTriangulation& triangulation, FacetId f) {
  const auto [a, b, c] = triangulation.facet_vertices(f);
  std::array<Point, 3> corners{triangulation.point(a), triangulation.point(b),
                               triangulation.point(c)};
  std::sort(corners.begin(), corners.end());
  return corners;
}

// Likewise. Precondition: a finite cell. O(1).
inline std::array<Point, 4> sorted_corners(const Triangulation& triangulation, CellId c) {
  std::array<Point, 4> corners;
  for (std::size_t i = 0; i < 4; ++i) {
    corners[i] = triangulation.point(triangulation.cell(c).vertices[i]);
  }
  std::sort(corners.begin(), corners.end());
  return corners;
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
