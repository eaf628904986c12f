// What those who go on from the stages of a reconstruction get of them, and what they know
// beforehand (steps/reconstruct_and_keep.h).
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "cocone/boundary_samples.h"
#include "cocone/cell_marks.h"
#include "cocone/extract_manifold.h"
#include "cocone/facet_set.h"
#include "cocone/facets/facet_removal.h"
#include "cocone/facets/linked_facets.h"
#include "cocone/known_labels.h"
#include "cocone/poles.h"
#include "cocone/reconstruct.h"
#include "cocone/umbrella.h"
#include "delaunay/triangulation.h"
#include "geom/execution.h"
#include "geom/id_vector.h"
#include "geom/point.h"

namespace cocoon {

// The Cocone surface as the marking had it.
struct CoconeSurface {
  std::vector<FacetId> halves;  // its facets, seen from the side of the walk
  VertexSet good;               // see umbrella.h; empty if the surface was not to be closed
  std::size_t umbrellas = 0;    // vertices that it has one closed umbrella at, good or not
  FirstWalk first_walk = FirstWalk::at_once;
  // Its facets linked, and the candidates off it; of reconstruct_tight_from only, and if anything
  // was marked.
  LinkedFacets triangles = {};
  RemovedFacets rest = {};
};

// What the stages found on the way, for those who go on from it: at first sight, even if the result
// is that of a second look (ReconstructCounters::second_look).
struct ReconstructStages {
  Triangulation triangulation;
  std::vector<CellId> not_in_doubles;  // of the dual
  Poles poles;
  BoundarySamples boundary;
  FacetSet candidates;  // before pruning
  FacetSet left;        // after it
  VertexSet umbrella;
  CoconeSurface surface;
  // If it was marked, which one that is certain is not: its facets, the marks before the peel, and
  // 1 for cells that are not of the body in the end; none if marks alone led to a second look.
  FacetSet marked;
  CellMarks marks;
  IdVector<CellId, std::uint8_t> out;
};

// What the stages up to pruning would find, if it is known beforehand (live_candidates.h).
struct KnownCandidates {
  IdVector<VertexId, Vec3> normals;  // of the poles
  VertexSet boundary;
  VertexSet umbrella;
  LinkedFacets left;                          // candidates after pruning
  ReconstructCounters counters;               // of these stages
  FirstWalk first_walk = FirstWalk::at_once;  // as far as it can be told
};

// A way to what mark_cells gives (kept_marks.h).
using Marking = std::function<CellMarks(
    const Triangulation& triangulation, const LinkedFacets& surface, const VertexSet& boundary,
    const KnownLabelsSource& known, const GoodVertexOptions& options, const Execution& execution)>;

// Whoever keeps a body (kept_body.h), and may take it instead of the mesh that bounds it: then each
// vertex has one closed umbrella of that. `out`: 1 = a cell is not of the body. `is_flawed`: the
// clean-up has seen a vertex without such an umbrella, or the mesh is needed in any case. False: it
// is needed. Not asked for the body of a second look.
using BodyTaker = std::function<bool(const Triangulation& triangulation,
                                     const IdVector<CellId, std::uint8_t>& out, bool is_flawed)>;

// What is known of a triangulation that changes, and who wants what it gives.
struct LiveStages {
  const IdVector<VertexId, CellId>& cell_at;  // a cell at each vertex
  Marking mark;
  BodyTaker take_body;
};

}  // namespace cocoon
