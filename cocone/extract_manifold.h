// Manifold extraction: one sheet out of the slightly thickened set of candidates.
//
// Where four samples nearly lie on a circle, all facets of a flat tetrahedron may be candidates.
// The surface is what a walker sees who stays on one side of it: from a candidate rotate about an
// edge, through the cells on the walker's side, to the first candidate met. That one belongs to the
// sheet; the others at the edge do not.
//
//        h  \   | g         standing on f, turning about the edge (o) over the upper side:
//            \  |           g comes first and is kept, h comes later and is dropped
//             \ | ______ f
//              (o)
#pragma once

#include <cstddef>
#include <vector>

#include "cocone/facets/facet_removal.h"
#include "cocone/facets/linked_facets.h"
#include "delaunay/triangulation.h"
#include "geom/execution.h"

namespace cocoon {

// How the first walk went, which makes no difference to its result: at once (walk_reach.h), or in
// rounds because that was not possible.
enum class FirstWalk { at_once, in_rounds };

struct ManifoldSurface {
  LinkedFacets triangles;
  // Of each triangle, at its place: the facet seen from the side on which the walk came. Normals of
  // facet_vertices(mirror(half)) point to that side: outward where the walk began outside.
  std::vector<FacetId> halves;
  std::size_t walks = 0;     // connected pieces
  std::size_t unwalked = 0;  // candidates on no walk and apart from all: kept as they are
  // Times that a walk met a facet it had taken from its other side: 0 where the surface has two
  // sides, small where the candidates are torn, large where the surface is one-sided.
  std::size_t back_contacts = 0;
  FirstWalk first_walk = FirstWalk::at_once;
  RemovedFacets rest;  // candidates not on the surface; of extract_again() only
};

// A walk goes in rounds: all facets kept in the last round turn about their edges at once; what is
// kept or dropped stays so. A facet that one round would both keep and drop is kept. One that it
// would keep from both sides is taken from the side on which the cell reaches farther: by the sum
// of squared distances from its fourth vertex to the corners, infinite cells farthest. Turns are
// made about edges with an umbrella at one end (`umbrella` as from prune_sharp_edges), so that a
// walk does not cross a rim. Two candidates alone at an edge see each other without a turn; at
// edges with more the turn goes through the cells.
// Walks begin at candidates with umbrellas at their three vertices, none of which is on the surface
// so far; of these at the one with the smallest circle (facet_size.h):
//  1. of the hull candidates, seen from outside;
//  2. when there are no more, of the others, seen from the side on which the cell reaches farther.
//     If all facets of that cell are candidates, which is the inside of a flat tetrahedron, from
//     the other side; at none where both sides are such.
// So the result is a function of the set of candidates. Only in exact ties does it depend on where
// the axes lie: lexicographic order settles them, of circles by the corners, of two sides for the
// positive one of the sorted corners. The first walk, which is nearly always the only one, goes
// without rounds, on all threads, if its result does not depend on them (walk_reach.h).
// Errors: InputError for parts of another triangulation, by their sizes (inputs/stage_inputs.h).
// Complexity: O(candidates + vertices), and one byte per cell; s log s for s places where further
// walks may begin. Source: Amenta, Choi, Dey & Leekha 2002 (manifold extraction); the walk about
// edges is that of the Tight Cocone program (Dey & Goswami 2003), the rounds are ours
// (docs/stages/extract_manifold.md). Classes of half-facets would need no rounds, but one tear that
// links the two sides makes them one class, and then both sheets of every flat tetrahedron stay; in
// rounds a tear does harm only where it is.
ManifoldSurface extract_manifold(const Triangulation& triangulation, LinkedFacets candidates,
                                 const VertexSet& umbrella, const Execution& execution = {});

// Overload for callers that extract a surface again and again, as candidates change here and there:
// returns the rest, too, and what failed the last time (`first_walk`) is not tried. Complexity: the
// same.
ManifoldSurface extract_again(const Triangulation& triangulation, LinkedFacets candidates,
                              const VertexSet& umbrella, FirstWalk first_walk,
                              const Execution& execution = {});

}  // namespace cocoon
