// Whether values given to a stage are those of its triangulation: who calls the stages by hand may
// mix up two of them, or leave out a stage. What is tested takes no time and finds nearly all.
#pragma once

#include "cocone/cocones.h"
#include "cocone/facets/linked_facets.h"
#include "cocone/poles.h"
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

}  // namespace cocoon
