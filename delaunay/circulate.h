// Walking around a vertex or an edge of a triangulation. Small inline functions, for checks,
// queries and experiments, and for the stages of Cocone that turn about edges or look at stars; the
// others are passes over all cells or facets.
//
//   around an edge ab: the facets at ab, in rotation. A facet is named as seen from the cell that
//   comes after it; crossing that cell gives the next one:
//
//          f1 ____              for_each_facet_around_edge(t, f0, a, b, visit)
//            /c1  \ c0          visits f0 (seen from c0), f1 (seen from c1), ... until f0 again.
//       f2 _/__ab__\_ f0        The cells passed are cell_of(f0), cell_of(f1), ..., the infinite
//           \  c2  /            ones included: a rotation never ends at the hull.
//            \____/
#pragma once

#include <cassert>
#include <cstddef>
#include <span>

#include "delaunay/triangulation.h"
#include "delaunay/vertex_stars.h"

namespace cocoon {

// The position (0..3) of v in the cell. Precondition: v is a vertex of it. O(1), without branches.
constexpr int index_of_vertex(const Cell& cell, VertexId v) {
  const auto& [v0, v1, v2, v3] = cell.vertices;
  assert(v0 == v || v1 == v || v2 == v || v3 == v);
  return static_cast<int>(v1 == v) + 2 * static_cast<int>(v2 == v) + 3 * static_cast<int>(v3 == v);
}

constexpr bool has_vertex(const Cell& cell, VertexId v) {
  const auto& [v0, v1, v2, v3] = cell.vertices;
  return v0 == v || v1 == v || v2 == v || v3 == v;
}

// Around an edge: of a Triangulation or of a TriangulationView.

// The vertex of facet f that is neither a nor b. Precondition: f contains a and b. O(1).
template <class AnyTriangulation>
VertexId third_vertex(const AnyTriangulation& triangulation, FacetId f, VertexId a, VertexId b) {
  const int* corner = facet_corners[index_of(f)];
  const Cell& cell = triangulation.cell(cell_of(f));
  for (int k = 0; k < 2; ++k) {
    const VertexId v = cell.vertices[static_cast<std::size_t>(corner[k])];
    if (v != a && v != b) return v;
  }
  return cell.vertices[static_cast<std::size_t>(corner[2])];
}

// The other facet of cell_of(f) at the edge ab. Precondition: f contains a and b. O(1).
template <class AnyTriangulation>
FacetId other_facet_at_edge(const AnyTriangulation& triangulation, FacetId f, VertexId a,
                            VertexId b) {
  // Facets are numbered by the opposite vertex: the vertices off the edge are f's own index, and
  // the one that is left of 0 + 1 + 2 + 3.
  const CellId c = cell_of(f);
  const Cell& cell = triangulation.cell(c);
  return facet_id(c, 6 - index_of_vertex(cell, a) - index_of_vertex(cell, b) - index_of(f));
}

// The next facet of the rotation about ab: through cell_of(f) to its other facet at ab, seen from
// the cell behind. Precondition: f contains a and b. O(1).
template <class AnyTriangulation>
FacetId next_facet_around_edge(const AnyTriangulation& triangulation, FacetId f, VertexId a,
                               VertexId b) {
  return triangulation.mirror(other_facet_at_edge(triangulation, f, a, b));
}

// Calls visit(FacetId) for every facet at the edge ab once, in rotation, beginning with f.
// Precondition: f contains a and b, both finite. Complexity: O(degree of the edge).
template <class AnyTriangulation, class Visit>
void for_each_facet_around_edge(const AnyTriangulation& triangulation, FacetId f, VertexId a,
                                VertexId b, Visit visit) {
  FacetId g = f;
  do {
    visit(g);
    g = next_facet_around_edge(triangulation, g, a, b);
  } while (g != f);
}

// Calls visit(FacetId) once for every facet, finite or not, that has v as a vertex, with the
// facet's canonical id, in the order of star(v). Complexity: O(star).
template <class Visit>
void for_each_facet_around_vertex(const Triangulation& triangulation, const VertexStars& stars,
                                  VertexId v, Visit visit) {
  for (const CellId c : stars.star(v)) {
    const int opposite = index_of_vertex(triangulation.cell(c), v);
    for (int i = 0; i < 4; ++i) {
      const FacetId f = facet_id(c, i);
      if (i != opposite && triangulation.canonical(f) == f) visit(f);
    }
  }
}

// Calls visit(k) for k = begin, ..., end - 1, which is to look at the star of vertex_at(k). The
// cells of the stars that come next are asked for in advance: they lie anywhere in memory, and half
// of the time would go by waiting for them. `stars`: VertexStars, or a StarCache that knows the
// stars (StarCache::expect). Complexity: O(stars), besides the visits.
template <class Stars, class VertexAt, class Visit>
void visit_stars(const Triangulation& triangulation, Stars& stars, std::size_t begin,
                 std::size_t end, VertexAt vertex_at, Visit visit) {
  constexpr std::size_t ahead = 2;
  for (std::size_t k = begin; k < end; ++k) {
    if (k + ahead < end) {
      for (const CellId c : stars.star(vertex_at(k + ahead))) {
        __builtin_prefetch(&triangulation.cell(c));
      }
    }
    visit(k);
  }
}

// True iff v is on the convex hull: some cell of its star is infinite. O(1) once the star is known,
// because stars are in increasing order and infinite cells come last.
// `stars`: VertexStars or StarCache.
template <class Stars>
bool is_hull_vertex(const Triangulation& triangulation, Stars& stars, VertexId v) {
  const std::span<const CellId> star = stars.star(v);
  return !star.empty() && triangulation.is_infinite(star.back());
}

}  // namespace cocoon
