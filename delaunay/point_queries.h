// Questions about one point: where does it lie, which vertex is nearest?
//
// All take a Triangulation or the view of a DynamicDelaunay. The answers are exact and depend on
// the points alone; the hint, a cell nearby, only saves time, and says which of several cells
// locate names where p lies on the border of each.
#pragma once

#include <array>
#include <vector>

#include "delaunay/triangulation_view.h"
#include "geom/point.h"

namespace cocoon {

enum class LocationKind {
  vertex,
  edge,
  facet,
  cell,
  outside,  // strictly beyond the convex hull
};

struct Location {
  LocationKind kind = LocationKind::outside;
  // A finite cell that contains the point, inside or on its border (the same for the same hint);
  // outside: an infinite cell whose hull facet the point lies strictly beyond.
  CellId cell;
  // The vertices of the face of the triangulation in whose relative interior the point lies, 1 to
  // 4 of them in increasing order, the rest none; outside: of the hull facet of `cell`.
  std::array<VertexId, 4> vertices;
};

// Walks from `hint` to p, or from the nearest of a sample of cells if it is none.
// Errors: InputError if the triangulation has no cells (a DynamicDelaunay without points), or the
// hint is none of them. Precondition: p finite.
// Complexity: O(n^(1/4)) expected for uniform points without a hint; a few cells from nearby.
// Source: Muecke, Saias & Zhu, Fast randomized point location without preprocessing (1996);
// delaunay/locate.h for the walk.
Location locate(const TriangulationView& triangulation, const Point& p, CellId hint = CellId());

// The vertex nearest to p, of equally near ones the lexicographically smallest. Greedy descent
// from a cell at p over Delaunay neighbors: a vertex that is not nearest has a neighbor that is
// nearer. Equally near vertices span a polytope with an empty sphere around p, whose edges are
// edges of the triangulation; along them lexicographic order, a linear function, has no local
// minimum but the global one. So distance first, order second, descends to the answer.
// Errors, precondition and complexity: as for locate, and the stars passed, a few on average.
VertexId nearest_vertex(const TriangulationView& triangulation, const Point& p,
                        CellId hint = CellId());

// All cells, finite and infinite, that have v as a vertex, in order of a flood from `cell`, which
// is one of them (DynamicDelaunay::cell_at), else InputError. For many vertices of a Triangulation,
// vertex_stars is faster. Complexity: O(star) expected.
std::vector<CellId> star_of_vertex(const TriangulationView& triangulation, VertexId v, CellId cell);

// The vertices that share an edge with v, without the infinite one, in increasing order.
// Errors and complexity: as for star_of_vertex, and sorting.
std::vector<VertexId> neighbors_of_vertex(const TriangulationView& triangulation, VertexId v,
                                          CellId cell);

}  // namespace cocoon
