// Peeling: what infinity can reach is taken away; the rest is the body.
//
// From the infinite cells on, a cell is reached through a facet if it is labeled OUT, or if it is
// poor (no good vertex: nothing is known about it) and the facet is not a stop facet. The stop
// facet of a poor cell is its facet with the smallest circumradius: holes of the surface are closed
// by small triangles.
#pragma once

#include "cocone/cell_marks.h"
#include "cocone/facet_set.h"
#include "delaunay/triangulation.h"
#include "geom/execution.h"

namespace cocoon {

struct PeelOptions {
  // What happens to good vertices that the marking did not reach, for instance on a surface that
  // outliers shield from the hull. True: the unvisited cell behind the largest facet (not on the
  // surface) next to a reached cell is taken as OUT, marked from its good vertices, and the peel
  // goes on; one at a time. False, as in the paper: they are demoted to poor and peeled.
  bool deferred_seeding = true;
};

struct CavityCounters {
  std::size_t cavities = 0;  // parts of the hollow
  std::size_t cells = 0;
};

// Returns the marks with `reached` filled in and the labels that the peel added. Labels are fixed
// while cells are reached; then the good vertices of the newly reached cells run marking rounds;
// repeated until nothing changes. The facet of a deferred seed is the one with the largest
// circumradius, ties go to the lexicographically smaller corners, as for stop facets.
// `marks.rounds` tells whether the labels are those of the one pass of mark_cells, which lead from
// every OUT cell to infinity: then there is nothing to flood but what is not labeled.
// Errors: InputError for parts of another triangulation, by their sizes (inputs/stage_inputs.h).
// Complexity: O(cells + d log d) for d facets of unvisited cells. Independent of order.
// Source: Dey & Goswami 2003 (Tight Cocone, peeling); rounds and deferred seeds are ours,
// docs/stages/peel_cells.md.
CellMarks peel_cells(const Triangulation& triangulation, const FacetSet& surface, CellMarks marks,
                     const PeelOptions& options = {}, const Execution& execution = {});

// Opens what closed surfaces inside the body enclose, such as the inner wall of a hollow part: its
// good vertices were not visited, for no surface joins them to infinity. Those that touch a cell
// known to be IN tell their sides from it (mark_cells.h); from the cells that are OUT by that, and
// from those that are known to be OUT beforehand (known_labels.h) at samples nowhere on the
// surface, the peel goes on, and so it does with what is found behind them: bodies within cavities.
// Repeated until nothing changes. Where `marks.reached` differs from the labels (clean_up_cells)
// the labels follow. Complexity: O(cells) for each depth of nesting. Independent of order.
// Errors: InputError if the marks do not come from peel_cells; Cancelled. Source: ours,
// docs/stages/peel_cells.md.
CavityCounters open_cavities(const Triangulation& triangulation, const FacetSet& surface,
                             CellMarks& marks, const Execution& execution = {});

}  // namespace cocoon
