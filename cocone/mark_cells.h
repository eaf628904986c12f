// Marking: which cells lie outside and which inside, told by the good vertices of the surface.
//
// At a good vertex the surface is one disk, which divides the cells around it (the infinite ones
// included) into two halves. A half that holds a cell known to be OUT is outside, the other one is
// inside. Beginning with the infinite cells, marks travel over the surface from good vertex to good
// vertex.
#pragma once

#include "cocone/cell_marks.h"
#include "cocone/facet_set.h"
#include "cocone/facets/linked_facets.h"
#include "cocone/known_labels.h"
#include "cocone/umbrella.h"
#include "delaunay/triangulation.h"
#include "geom/execution.h"

namespace cocoon {

// Labels all infinite cells OUT and runs rounds: the good vertices on triangles of the last round's
// vertices (at first: of infinite cells) are all decided from the labels of earlier rounds, then
// their stars are labeled. A half that holds OUT cells and no IN cells is outside, and the other
// way round; where both labels occur the half's majority counts, a tie is OUT, and it is counted as
// a conflict. Nothing is overwritten; a cell told both in one round takes what most of its vertices
// say, of two and two OUT, also counted.
// A vertex whose star is labeled already passes on the turn and is not examined for conflicts.
// One pass over the cells (carried_marks.h) gives the same labels where no two vertices disagree;
// of the others those are asked, round by round, whom the disagreement touches (disputed_marks.h).
// Errors: InputError for parts of another triangulation, by their sizes (inputs/stage_inputs.h).
// Complexity: O(cells). Rounds read only earlier rounds: independent of order.
// Source: Dey & Goswami 2003 (Tight Cocone, marking); rounds and majorities are ours,
// docs/stages/mark_cells.md.
CellMarks mark_cells(const Triangulation& triangulation, const LinkedFacets& surface,
                     const VertexSet& boundary, const GoodVertexOptions& options = {},
                     const Execution& execution = {});

// The same with labels that are known beforehand. Here they count only where vertices disagree (the
// clean-up heeds CellMarks::known elsewhere, too), which is where marks may have gone astray: then
// the known cells that touch a good vertex have their labels before the first round, and their good
// vertices are among the first. Good vertices whose halves known cells contradict are no longer
// good (refuted_vertices).
CellMarks mark_cells(const Triangulation& triangulation, const LinkedFacets& surface,
                     const VertexSet& boundary, const KnownLabelsSource& known,
                     const GoodVertexOptions& options = {}, const Execution& execution = {});

// The same where the good vertices are known: good_vertices(surface, boundary, options).
CellMarks mark_cells(const Triangulation& triangulation, const LinkedFacets& surface,
                     GoodVertices good, const KnownLabelsSource& known,
                     const Execution& execution = {});

// Marks without the vertices that labels put in doubt, whether or not vertices disagree: good
// vertices that cells of `known` contradict, and those that no mark reaches after that on parts of
// the surface which cells of `likely` touch, as on a floor behind what closes the mouth of its
// pocket. They are no longer good (refuted_vertices). The labels mark nothing themselves, and are
// not in CellMarks::known: whoever wants the clean-up to heed them puts them there. Both: as many
// as there are cells. Errors, complexity and determinism as above. Source: ours,
// docs/stages/known_labels.md, likely labels.
CellMarks mark_undoubted_cells(const Triangulation& triangulation, const LinkedFacets& surface,
                               GoodVertices good, const IdVector<CellId, CellLabel>& known,
                               const IdVector<CellId, CellLabel>& likely,
                               const Execution& execution = {});

}  // namespace cocoon
