// The size of a facet: the radius of the circle through its corners.
#pragma once

#include <array>

#include "delaunay/triangulation_view.h"
#include "geom/point.h"

namespace cocoon {

// With the corners in lexicographic order, which settle ties: no two facets are equal.
struct FacetSize {
  double squared_circumradius;
  std::array<Point, 3> corners;

  // Smaller circle first; of equal circles the lexicographically smaller corners.
  friend bool operator<(const FacetSize& a, const FacetSize& b) {
    if (a.squared_circumradius != b.squared_circumradius) {
      return a.squared_circumradius < b.squared_circumradius;
    }
    return a.corners < b.corners;
  }
};

// R = |u| |v| |u - v| / (2 |u x v|), squared; infinite for collinear corners. The same bits from
// both sides of the facet. Precondition: a finite facet. O(1).
FacetSize size_of_triangle(const std::array<Point, 3>& sorted_corners);
FacetSize size_of_facet(const TriangulationView& triangulation, FacetId f);

}  // namespace cocoon
