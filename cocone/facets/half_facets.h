// Facets seen from one of their sides, and how a walker who stays on his side goes from one to the
// next.
#pragma once

#include <cstdint>

#include "cocone/facets/linked_facets.h"
#include "delaunay/circulate.h"
#include "delaunay/triangulation.h"

namespace cocoon {

// A triangle of LinkedFacets seen from one of its sides: 2 * triangle, from the cell that numbers
// the facet, or 2 * triangle + 1, from the one behind.
using Half = std::uint32_t;

constexpr std::uint32_t triangle_of_half(Half half) { return half / 2; }
constexpr Half other_half(Half half) { return half ^ 1U; }

inline FacetId facet_of_half(const LinkedFacets& triangles, Half half) {
  const std::uint32_t t = triangle_of_half(half);
  return (half & 1U) == 0 ? triangles.facets[t] : triangles.mirrors[t];
}

// Whether two triangles run through their common edge in the same direction.
inline bool run_alike(const LinkedFacets& triangles, Halfedge halfedge, Halfedge other) {
  return triangles.ends(halfedge)[0] == triangles.ends(other)[0];
}

// Of the triangle of `other`, the half on the walker's side when he comes from `half` over their
// edge: seen from one side, the triangles run through it in opposite directions.
inline Half facing_half(const LinkedFacets& triangles, Half half, Halfedge halfedge,
                        Halfedge other) {
  return 2 * triangle_of_halfedge(other) +
         ((half & 1U) ^ (run_alike(triangles, halfedge, other) ? 1U : 0U));
}

// Whether walks turn about the edge of the halfedge: there is another triangle, and an umbrella at
// one end.
inline bool is_crossed(const LinkedFacets& triangles, const VertexSet& umbrella,
                       Halfedge halfedge) {
  const auto [a, b] = triangles.ends(halfedge);
  return triangles.links[halfedge] != halfedge && (umbrella[a] | umbrella[b]) != 0;
}

// Of the two other triangles at an edge with three the halfedge of the one that a walker meets
// first, when he turns about it from `half`; no_halfedge if one would have to look at the cells
// between them. Two facets of one cell have nothing between them. O(1).
inline Halfedge first_of_two(const LinkedFacets& triangles, Half half, Halfedge halfedge) {
  const Halfedge a = triangles.links[halfedge];
  const Halfedge b = triangles.links[a];
  const Half at_a = facing_half(triangles, half, halfedge, a);
  const Half at_b = facing_half(triangles, half, halfedge, b);
  const auto are_in_one_cell = [&](Half h, Half k) {
    return cell_of(facet_of_half(triangles, h)) == cell_of(facet_of_half(triangles, k));
  };
  const auto is_first = [&](Half first, Half second) {
    return are_in_one_cell(half, first) || are_in_one_cell(other_half(first), second) ||
           are_in_one_cell(other_half(second), other_half(half));
  };
  if (is_first(at_a, at_b)) return a;
  return is_first(at_b, at_a) ? b : no_halfedge;
}

// Once around the edge of the halfedge, beginning on the side of `half`: calls meet(half, halfedge)
// for the other triangles in the order in which they are met, as they are seen from there.
// Complexity: O(cells at the edge).
template <class Meet>
void turn_about_edge(const Triangulation& triangulation, const LinkedFacets& triangles, Half half,
                     Halfedge halfedge, Meet meet) {
  const auto meet_halfedge = [&](Halfedge met) {
    meet(facing_half(triangles, half, halfedge, met), met);
  };
  if (triangles.has_three_triangles(halfedge)) {
    const Halfedge first = first_of_two(triangles, half, halfedge);
    if (first != no_halfedge) {
      const Halfedge next = triangles.links[first];
      meet_halfedge(first);
      meet_halfedge(next != halfedge ? next : triangles.links[halfedge]);
      return;
    }
  }
  FacetId f = facet_of_half(triangles, half);
  const FacetId back = triangulation.mirror(f);
  VertexId third = triangles.corners[triangle_of_halfedge(halfedge)][corner_of_halfedge(halfedge)];
  for (;;) {
    const FacetId g = facet_id(cell_of(f), index_of_vertex(triangulation.cell(cell_of(f)), third));
    if (g == back) return;
    if (triangles.set.contains(g)) {
      const FacetId canonical = triangulation.canonical(g);
      Halfedge met = halfedge;
      while (triangles.facets[triangle_of_halfedge(met)] != canonical) met = triangles.links[met];
      meet_halfedge(met);
    }
    third = triangulation.opposite_vertex(f);
    f = triangulation.mirror(g);
  }
}

}  // namespace cocoon
