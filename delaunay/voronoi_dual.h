// The Voronoi diagram of the vertices, read off the Delaunay triangulation.
// Source: the textbook duality; which centers can be trusted is ours, docs/stages/voronoi_dual.md.
#pragma once

#include <cstddef>
#include <vector>

#include "delaunay/triangulation.h"
#include "geom/execution.h"
#include "geom/id_vector.h"
#include "geom/point.h"

namespace cocoon {

struct Dual {
  // Finite cell: its Voronoi vertex, the circumcenter. Infinite cell: the unit direction of its
  // Voronoi ray, the outward normal of the hull facet (oriented by the finite cell behind it).
  IdVector<CellId, Point> centers;  // empty in a lean dual
  // How they were obtained where floating point did not suffice (geom/circumsphere.h,
  // geom/triangle_normal.h).
  std::size_t exact_centers = 0;       // centers and directions computed in exact integers
  std::size_t facet_fallbacks = 0;     // center of a facet, or the centroid; never for exact cells
                                       // unless the true center is beyond the range of double
  std::vector<CellId> not_in_doubles;  // the cells of both counts, ascending
  // A lean dual (delaunay/voronoi/lean_dual.h) keeps the Voronoi vertices that were hard to get and
  // the rays; the others are computed anew by who looks at them, which takes no longer than to
  // write and read them.
  std::vector<Point> hard_centers;  // of the finite cells of not_in_doubles
  std::vector<Vec3> rays;           // of the infinite cells

  bool is_lean() const { return centers.empty(); }
};

// Complexity: O(cells). Deterministic: each center is computed from the cell's vertices in
// lexicographic order, so equal cells give equal bits.
Dual voronoi_dual(const Triangulation& triangulation, const Execution& execution = {});

// The element of Dual::centers of one cell, bit for bit: for stages that look at few cells. O(1).
Point voronoi_vertex(const Triangulation& triangulation, CellId c);

// Overload for callers that already have a dual, lean or not: O(1), O(log hard centers) if lean.
Point center_of(const Triangulation& triangulation, const Dual& dual, CellId c);

// The dual of a finite facet: segment between two Voronoi vertices, or a ray.
struct DualEdge {
  Point from;  // a Voronoi vertex (of the finite cell if the other one is infinite)
  Vec3 to;     // the other Voronoi vertex, or the unit direction of the ray
  bool is_ray = false;
};

// Precondition: f is a finite facet. O(1).
DualEdge dual_edge(const Triangulation& triangulation, const Dual& dual, FacetId f);

}  // namespace cocoon
