// Pruning: candidates that stand off the surface at sharp edges go.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "cocone/facet_set.h"
#include "cocone/facets/linked_facets.h"
#include "delaunay/triangulation.h"
#include "geom/execution.h"

namespace cocoon {

struct PruneOptions {
  // An edge is sharp if all its candidates lie within a smaller dihedral than this: cos 60 degrees.
  double sharp_cosine = 0.5;
  // Two candidates at an edge, flatter than this dihedral cosine (134.4 degrees or more), stay.
  double keep_cosine = -0.7;
};

struct PrunedCandidates {
  LinkedFacets left;           // what was not pruned
  VertexSet umbrella;          // flags of vertices with an umbrella, before anything was pruned
  std::size_t candidates = 0;  // before
  std::size_t pruned = 0;
  std::size_t umbrellas = 0;  // vertices with an umbrella
};

// 1. Umbrella flags of all vertices (umbrella.h). 2. Where an edge has exactly two candidates that
// lie nearly flat, both are to stay. 3. At a sharp edge whose two ends have an umbrella all other
// candidates go; repeated, since an edge that loses a candidate may become sharp (one candidate is
// always sharp). Flags, and who is to stay, are those of all candidates, and the largest dihedral
// at an edge can only fall: the result does not depend on order.
// Errors: InputError for parts of another triangulation, by their sizes, and for options out of
// range (inputs/stage_inputs.h).
// Complexity: O(candidates + vertices) and one byte per cell; the first step parallel.
// Source: Amenta, Choi, Dey & Leekha 2002; Woo & Dey 2005, section 2.2; guard by umbrellas and
// thresholds after the Tight Cocone program (docs/stages/prune_sharp_edges.md).
PrunedCandidates prune_sharp_edges(const Triangulation& triangulation, FacetSet candidates,
                                   const PruneOptions& options = {},
                                   const Execution& execution = {});

// Overload for callers that already have the candidates as a list.
PrunedCandidates prune_sharp_edges(const Triangulation& triangulation,
                                   CandidateTriangles candidates, const PruneOptions& options = {},
                                   const Execution& execution = {});

// On a part of the candidates. One flag per triangle: 1 = prune_sharp_edges would remove it, as far
// as the edges with a vertex of `core` tell; all triangles at these vertices must be there.
// `umbrella`: of all vertices. Triangles with one core vertex have an edge that is not looked at.
// If each of them ends as it did when the whole was pruned, before something changed at core
// vertices only, then the flags, and what is known of all other triangles, are together what
// pruning the whole gives: what is removed here is removed without help from outside, and what is
// not stays by the triangles that stay. Complexity: O(triangles). Source: ours,
// docs/stages/live_update.md.
std::vector<std::uint8_t> prune_part(const LinkedFacets& triangles, const VertexSet& core,
                                     const VertexSet& umbrella, const PruneOptions& options = {});

}  // namespace cocoon
