// The rounds of mark_cells, run only where vertices disagree.
#pragma once

#include "cocone/carried_marks.h"
#include "cocone/linked_facets.h"
#include "cocone/mark_cells.h"

namespace cocoon {

// Makes of carried marks those of the rounds: the same labels, conflicts and number of rounds. A
// vertex whose cells were all labeled before its turn as the side carried to it wants decides as
// that side wants; so it need not be asked. The others are, round by round: first those at disputed
// cells, then those at cells that came out otherwise than carried. Nothing is done if nobody
// disagrees. Precondition: marks come from carry_marks.
// Complexity: O(vertices) for the rounds in which they have their turns, O(star) for each vertex
// that is asked. Independent of order. Source: spec 6.1, 6.2, section 12; the shortcut is ours.
void settle_disputes(const Triangulation& triangulation, const LinkedFacets& surface,
                     const IdVector<VertexId, SideId>& corner_at, const CarriedMarks& carried,
                     CellMarks& marks);

}  // namespace cocoon
