// Whether values given to a stage are those of its triangulation, and its options numbers that it
// can work with: who calls the stages by hand may mix up two triangulations, or leave out a stage,
// or give an angle where its cosine is meant. What is tested takes no time and finds nearly all.
#pragma once

#include "cocone/boundary_options.h"
#include "cocone/cocones.h"
#include "cocone/facets/linked_facets.h"
#include "cocone/poles.h"
#include "cocone/prune_sharp_edges.h"
#include "cocone/umbrella.h"
#include "delaunay/triangulation.h"
#include "delaunay/voronoi_dual.h"

namespace cocoon {

// All throw InputError, with the name of the stage. Complexity: O(1).
void require_dual(const char* stage, const Triangulation& triangulation, const Dual& dual);
// With their heights and degenerate vertices.
void require_poles(const char* stage, const Triangulation& triangulation, const Poles& poles);
void require_cocones(const char* stage, const Triangulation& triangulation, const Cocones& cocones);
void require_vertex_flags(const char* stage, const Triangulation& triangulation,
                          const VertexSet& flags);
void require_facets(const char* stage, const Triangulation& triangulation, const FacetSet& facets);
// Of no triangles the set may be empty, too.
void require_facets(const char* stage, const Triangulation& triangulation,
                    const LinkedFacets& facets);

// Cosines from -1 to 1, of a cone from 0 on; rho at least 0. Limits for dihedral cosines may be
// any number: beyond 1 no edge is meant, beyond -1 every one.
void require_options(const char* stage, const CoconeOptions& options);
void require_options(const char* stage, const BoundaryOptions& options);
void require_options(const char* stage, const PruneOptions& options);
void require_options(const char* stage, const GoodVertexOptions& options);

}  // namespace cocoon
