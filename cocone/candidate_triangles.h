// Candidate triangles: the facets whose dual edges meet the cocones of their interior corners.
#pragma once

#include <vector>

#include "cocone/cocones.h"
#include "cocone/facet_set.h"
#include "delaunay/triangulation.h"
#include "geom/execution.h"
#include "geom/triangle_mesh.h"

namespace cocoon {

// A facet is a candidate iff at least one of its vertices is interior and its dual edge meets the
// cocone of every interior vertex. Boundary samples neither veto nor suffice; with no boundary
// sample (a flag of 0 for each vertex) every vertex votes: plain Cocone.
// Errors: InputError for parts of another triangulation, by their sizes (inputs/stage_inputs.h).
// Complexity: O(facets of `cocones`), and one byte per cell. Deterministic: one facet at a time.
// Source: Woo & Dey 2005, section 2.2; Dey & Giesen 2001 (with boundary).
FacetSet candidate_triangles(const Triangulation& triangulation, const Cocones& cocones,
                             const VertexSet& boundary, const Execution& execution = {});

// And as a list: what link_facets() takes.
struct CandidateTriangles {
  FacetSet set;
  std::vector<FacetId> facets;    // canonical ids, ascending
  std::vector<Triangle> corners;  // of each: Triangulation::facet_vertices
};
CandidateTriangles list_candidate_triangles(const Triangulation& triangulation,
                                            const Cocones& cocones, const VertexSet& boundary,
                                            const Execution& execution = {});

}  // namespace cocoon
