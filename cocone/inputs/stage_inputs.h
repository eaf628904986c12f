// Whether values given to a stage are those of its triangulation, and its options numbers that it
// can work with: who calls the stages by hand may mix up two triangulations, or leave out a stage,
// or give an angle where its cosine is meant. What is tested takes no time and finds nearly all.
#pragma once

#include "cocone/boundary_options.h"
#include "cocone/cell_marks.h"
#include "cocone/cocones.h"
#include "cocone/facets/linked_facets.h"
#include "cocone/poles.h"
#include "cocone/prune_sharp_edges.h"
#include "cocone/umbrella.h"
#include "delaunay/triangulation.h"
#include "delaunay/voronoi_dual.h"

namespace cocoon {

struct BoundaryLoopOptions;
struct CleanUpOptions;
struct NoiseOptions;

// All throw InputError, with the name of the stage. Complexity: O(1).
void require_dual(const char* stage, const Triangulation& triangulation, const Dual& dual);
// With their heights and degenerate vertices.
void require_poles(const char* stage, const Triangulation& triangulation, const Poles& poles);
// With the cosine of a cone.
void require_sides(const char* stage, const Triangulation& triangulation, const ConeSides& sides);
void require_cocones(const char* stage, const Triangulation& triangulation, const Cocones& cocones);
void require_vertex_flags(const char* stage, const Triangulation& triangulation,
                          const VertexSet& flags);
void require_facets(const char* stage, const Triangulation& triangulation, const FacetSet& facets);
// Of no triangles the set may be empty, too.
void require_facets(const char* stage, const Triangulation& triangulation,
                    const LinkedFacets& facets);
// After the marking.
void require_marked(const char* stage, const Triangulation& triangulation, const CellMarks& marks);
// After the peel.
void require_peeled(const char* stage, const Triangulation& triangulation, const CellMarks& marks);
// What clean_up_cells() takes.
void require_clean_up(const char* stage, const Triangulation& triangulation, const Poles& poles,
                      const CellMarks& marks, const CleanUpOptions& options,
                      const IdVector<VertexId, CellId>* cell_at);

// Cosines from -1 to 1, of a cone from 0 on; rho at least 0. Limits for dihedral cosines may be
// any number: beyond 1 no edge is meant, beyond -1 every one.
void require_options(const char* stage, const CoconeOptions& options);
void require_options(const char* stage, const BoundaryOptions& options);
void require_options(const char* stage, const PruneOptions& options);
void require_options(const char* stage, const GoodVertexOptions& options);

// Costs, ratios and links at least 0, infinity too; shares from 0 to 1; cosines from -1 to 1; at
// least one neighbor; of four vertices of a cell, no more than four that support it.
void require_options(const char* stage, const CleanUpOptions& options);
void require_options(const char* stage, const NoiseOptions& options);
void require_options(const char* stage, const BoundaryLoopOptions& options);
void require_neighbors(const char* stage, std::size_t neighbors);

}  // namespace cocoon
