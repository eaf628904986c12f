// Marking by its definition: round after round over the whole surface.
#pragma once

#include <span>

#include "cocone/cell_marks.h"
#include "cocone/facet_set.h"
#include "delaunay/triangulation.h"

namespace cocoon::ref {

// Labels all infinite cells OUT and runs all rounds, without what replaces them in mark_cells. The
// first to have their turn are the good ones among the seeds, each of which touches an infinite
// cell or one that has a label already. Precondition: nobody is visited; good vertices are known.
// Complexity: O(cells).
void mark_in_rounds(const Triangulation& triangulation, const FacetSet& surface,
                    std::span<const VertexId> seeds, CellMarks& marks);

}  // namespace cocoon::ref
