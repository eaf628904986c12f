// The rounds of mark_cells, run only where vertices disagree.
#pragma once

#include <span>

#include "cocone/cell_marks.h"
#include "cocone/facets/linked_facets.h"
#include "cocone/marking/carried_marks.h"

namespace cocoon {

// Makes of carried marks those of the rounds: the same labels, conflicts and number of rounds. A
// vertex whose cells were all labeled before its turn as the side carried to it wants decides as
// that side wants; so it need not be asked. The others are, round by round: first those at disputed
// cells and at known ones that were carried otherwise, then those at cells that came out otherwise
// than carried. `seeds`: the good ones of these have their turn first. `known`: labels that finite
// cells have before the rounds; may be empty. Precondition: marks come from carry_marks, good seeds
// are visited, and good vertices on the hull and of known cells are seeds.
// Complexity: O(vertices) for the rounds in which they have their turns, O(star) for each vertex
// that is asked. Independent of order. Source: Dey & Goswami 2003 (Tight Cocone, marking); rounds
// and shortcut are ours, docs/stages/mark_cells.md.
void settle_disputes(const Triangulation& triangulation, const LinkedFacets& surface,
                     const IdVector<VertexId, Halfedge>& corner_at, const CarriedMarks& carried,
                     std::span<const VertexId> seeds, const IdVector<CellId, CellLabel>& known,
                     CellMarks& marks, const Execution& execution);

}  // namespace cocoon
