// Umbrellas: closed fans of triangles around a vertex.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "cocone/facet_set.h"
#include "cocone/facets/linked_facets.h"
#include "geom/execution.h"

namespace cocoon {

// Which of the `num_vertices` vertices have some closed cycle of triangles around them in which
// consecutive ones meet at a dihedral of at least the given angle (cosine: `sharp_cosine`, so
// dihedral cosine <= it). Found without a search: around a vertex, drop every triangle that has no
// partner left at one of its two spokes, until nothing changes; a cycle exists iff a triangle
// survives (a walk from partner to partner in a finite set closes), and a survivor never comes with
// fewer than two others. Where each spoke has two triangles, flat enough, nothing would be dropped:
// one look at every edge settles nearly all vertices.
// Errors: InputError for a triangle with another vertex.
// Greatest fixed point: independent of order. Complexity: O(triangles + vertices) for bounded
// valence; parallel over edges.
// Source: the guard of the Tight Cocone program (Dey & Goswami 2003); to find umbrellas
// without a search is ours.
VertexSet vertices_with_umbrella(const LinkedFacets& triangles, std::size_t num_vertices,
                                 double sharp_cosine, const Execution& execution = {});

// Overload for callers that already have `steep`: steep_edges(triangles, sharp_cosine).
VertexSet vertices_with_umbrella(const LinkedFacets& triangles, std::span<const Halfedge> steep,
                                 std::size_t num_vertices, double sharp_cosine,
                                 const Execution& execution = {});

struct GoodVertexOptions {
  // A fold: two triangles at an edge with a dihedral cosine of at least this (25.8 degrees or less)
  // make both ends poor; sharp folds give inconsistent marks.
  double fold_cosine = 0.9;
  // A dihedral cosine above this (below 90 degrees) makes the ends poor that are boundary samples.
  double crease_cosine = 0.0;
};

struct GoodVertices {
  VertexSet good;  // 1 = its triangles form one closed umbrella, and it was not demoted
  IdVector<VertexId, Halfedge> corner_at;  // of each vertex in a triangle: one opposite to it
  std::size_t count = 0;                   // good vertices
  std::vector<VertexId> folded;  // demoted: closed umbrellas at a fold or crease; increasing
};

// A vertex is good iff its triangles form exactly one closed umbrella: every spoke has two of
// them, and they make one cycle. All others are poor: rims, pinched vertices, spokes with three
// triangles, isolated samples. Demotions look at the umbrellas only, not at other demotions, so
// they do not depend on order.
// Errors: InputError for options that are no numbers, and if `boundary` has no flag for a vertex of
// a triangle.
// Complexity: O(triangles + vertices), parallel over vertices; edges are looked at only where they
// are steep (linked_facets.h), unless the options ask for flatter ones.
// Source: Dey & Goswami 2003 (Tight Cocone).
GoodVertices good_vertices(const LinkedFacets& triangles, const VertexSet& boundary,
                           const GoodVertexOptions& options = {}, const Execution& execution = {});

}  // namespace cocoon
