// Eight tetrahedra that can be counted by hand.
#pragma once

#include <algorithm>
#include <vector>

#include "cocone/facet_set.h"
#include "delaunay/delaunay.h"
#include "delaunay/triangulation.h"

namespace cocoon {

// The octahedron with its center: eight tetrahedra, eight hull facets, twelve inner facets.
struct Octahedron {
  Octahedron()
      : triangulation(
            delaunay(
                std::vector<Point>{
                    {1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}, {0, 0, 0}})
                .triangulation) {}

  VertexId vertex(const Point& p) const {
    for (const VertexId v : triangulation.vertices()) {
      if (triangulation.point(v) == p) return v;
    }
    return {};
  }
  bool on_hull(FacetId f) const {
    return triangulation.is_infinite(cell_of(f)) ||
           triangulation.is_infinite(cell_of(triangulation.mirror(f)));
  }
  // Facets for which `wanted` holds.
  template <class Wanted>
  FacetSet facets(Wanted wanted) const {
    FacetSet set(triangulation.num_cells());
    for (const CellId c : triangulation.finite_cells()) {
      for (int i = 0; i < 4; ++i) {
        if (wanted(facet_id(c, i))) set.insert(triangulation, facet_id(c, i));
      }
    }
    return set;
  }
  // The hull, and an inner facet that hangs into it from the edge (1,0,0)-(0,1,0).
  FacetSet hull_with_flap() const {
    const VertexId x = vertex({1, 0, 0});
    const VertexId y = vertex({0, 1, 0});
    const VertexId center = vertex({0, 0, 0});
    return facets([&](FacetId f) {
      return on_hull(f) || (contains(f, x) && contains(f, y) && contains(f, center));
    });
  }
  bool contains(FacetId f, VertexId v) const {
    const auto corners = triangulation.facet_vertices(f);
    return std::find(corners.begin(), corners.end(), v) != corners.end();
  }

  Triangulation triangulation;
};

inline VertexSet no_boundary(const Triangulation& t) { return VertexSet(t.num_vertices(), 0); }

}  // namespace cocoon
