// Clean-up after the peel: undecided cells are labeled anew as a whole, then defects are repaired.
//
// One energy judges a labeling of the finite cells as OUT or IN (infinite cells are OUT):
//
//   E =  sum over surface facets of  1 - min(cos phi, cos psi)           quality of a facet, 0 .. 2
//      + stretch_cost     * sum over surface facets of max(0, 1 - stretch_ratio spacing / length)
//      + evidence_weight  * sum over undecided cells of max(0, contrary - own evidence)
//      + mark_weight      * (decided cells that have left their label)
//      + defect_cost      * (non-manifold edges + pinched vertices, with multiplicity)
//      + idle_cost        * (samples that do nothing for the surface: idle_samples.h)
//      + unused_cost      * (samples of undecided cells that are not on the surface, no outliers)
//      - handle_cost / 2  * (Euler characteristic of the surface)
//      + component_cost   * (parts of the body)
//
// phi, psi: angles between the facet and the circumballs on its two sides: 0 where both balls are
// large, as across a well sampled surface. length, spacing: longest edge of a facet, largest
// spacing of its samples (sample_spacing.h, by three edges). A cell is undecided if none of its
// vertices is good (a poor cell of the peel), or if at most thin_support are and it hangs together
// with such cells, or labels are in conflict there (doubtful_region.h). The evidence comes from the
// poles (label_evidence.h). Cells whose sides an old mesh tells (CellMarks::known) are decided, and
// never leave their labels, but for OUT ones in cavities that are filled (1).
//
//  1. Cut. The first three terms are minimized over all labelings of the undecided cells, those of
//     the others held as marked: a minimum cut, so a global optimum; of several the one with most
//     IN cells. Flat cells (ball_cosines.h) are no part of that: other cells meet through them,
//     each of their facets counting half, and they are OUT if one of their sides is. OUT cells that
//     infinity cannot reach through OUT cells are then filled, as in the peel, but for hollows that
//     are to be kept (known_hollows.h).
//  2. Moves. At a defect or an unused sample single cells, pairs, and parts of stars change sides
//     where that lowers E, unless they would begin a new part of the body or a cavity, or what they
//     leave would fall apart, or reach far for a sample that is near the surface (far_reach.h).
//  3. Clusters. At idle samples, in doubt or beside those in doubt, whole clusters of cells
//     (cell_cluster.h) change sides where that lowers E, under the same conditions, and if no
//     sample on the surface is left out: holes of which only the rims are sampled open. Moves
//     again.
//  4. Small parts of the body (small_parts.h) in the doubtful region are dropped where that lowers
//     E. Moves again.
//  5. Compound moves. At what is still a defect or an unused sample, moves that make it cost less,
//     though E rises by up to max_rise, are tried (the cheapest max_openings) with all moves that
//     then lower E (compound_move.h), and taken with them where E falls in all. Moves again.
//  6. Handles. A closed path of three edges at doubtful vertices that is no facet and does not
//     divide the surface is the girth of a handle (handle_loops.h): where cells beside it can fill
//     or cut the handle so that E falls, the rest of it rises by max_closing_rise at most, and no
//     sample leaves the surface, they change sides (handle_closing.h). Moves again.
//  What is undecided over a volume (most_clump_cells) is left to the peel. Where no cell is
//  undecided or known and no edge or vertex pinched nothing changes. E falls strictly in 2 to 6,
//  and there are finitely many labelings, so this ends.
#pragma once

#include <cstddef>

#include "cocone/cell_marks.h"
#include "cocone/energy/idle_samples.h"
#include "cocone/poles.h"
#include "delaunay/triangulation.h"
#include "geom/execution.h"

namespace cocoon {

// Costs in the unit of the facet term; chosen on 23 models (docs/stages/clean_up_cells.md). Those
// beyond 2^20, infinity too, count as 2^20.
struct CleanUpOptions {
  bool enabled = true;
  // Undecided cells that hang together in larger numbers than both of these, a number and a share
  // of all finite cells, stay as the peel has them: they fill a volume, and no sample tells where
  // in it a surface should be. Bounds the work on samples that are of no surface.
  std::size_t most_clump_cells = 100000;
  double most_clump_share = 0.5;
  // A facet between samples that lie far closer to others costs up to this much more. Without it
  // slivers across the empty space change sides to use samples inside a noisy layer.
  double stretch_cost = 3;
  double stretch_ratio = 6;  // longer than so many spacings; below, thin walls lose samples
  // A facet costs 1 at most if the balls lie on its two sides: 2.25 overrules most surfaces. Above,
  // noisy layers get handles; from 1.5 down thin plates lose holes.
  double evidence_weight = 2.25;
  // As evidence, the two poles of a sample lie on different sides of the surface. That counts in
  // full if the nearer one is full_pole_ratio spacings off, and not at all up to near_pole_ratio:
  // both poles of a sample inside a layer of noise lie on one side. Above, thin plates lose holes;
  // 0, 0: always; the first is at most the second. Beside sharp edges poles are near, too; so it
  // counts in full, too, where so large a share of the samples around is good, and proportionally
  // below.
  double near_pole_ratio = 0.75;
  double full_pole_ratio = 2.25;
  double pole_good_share = 0.5;
  // Below 0.4 well sampled thin parts shrink; above 1 wrong marks of bad samples stay.
  double mark_weight = 0.5;
  // Cells are flat whose height is at most this much of the size of their largest facet: four
  // samples in one plane, up to the rounding of single precision. Their balls say nothing
  // (ball_cosines.h).
  double flat_ratio = 2e-6;
  // Cells with at most so many good vertices are undecided where they hang together with cells that
  // have none: there, good vertices are often wrong. 3: flat faces whose rims alone are sampled get
  // handles; 0: samples beside those in doubt are left out, and edges are cut off.
  int thin_support = 2;
  // What the label of such a cell weighs as evidence, from 0 to 1. Below, thin walls get handles;
  // above, edges are cut off.
  double mark_credit = 0.75;
  // At samples with more cells no moves are looked for: each look is at all of them, and whatever
  // changes there asks again. One that faces a densely sampled wall from afar has as many cells as
  // the wall has samples.
  std::size_t most_move_cells = 3000;
  double defect_cost = 16;
  double unused_cost = 8;  // a tent over one triangle costs less than 6
  // A sample that is not on the surface, but no farther from it than so many of its spacings, is
  // brought there by no cell that has a good vertex and an edge longer than stretch_ratio spacings
  // (far_reach.h). 0: by any; then slivers from the far side of the body change sides for it.
  double near_surface = 0.5;
  // A sample that the peel left out is not missed if its spacing exceeds this many times the median
  // of its neighbors' (sample_spacing.h, by three edges): it would become a spike.
  double outlier_ratio = 2.5;
  double handle_cost = 32;  // at 16 drilled rings and thin walls get more handles
  double idle_cost = 8;     // as much as if they were not on the surface; 0: no clusters
  IdleOptions idle = {};
  double deep_cosine = 0.9;  // of a cluster: below, walls of thick plates are crossed
  // Then of closer clusters, at samples that are still idle: above, a hole is several.
  double deeper_cosine = 0.95;
  // Larger clusters are not asked: the inner cells of a body are one, too. Nor are larger parts of
  // the body dropped.
  std::size_t most_cluster_cells = 10000;
  // Of the first of several moves. Nearly all that help begin with less; below 20, half of them are
  // not found.
  double max_rise = 100;
  std::size_t max_openings = 10;  // tried at a vertex, cheapest first: further ones do not help
  // By how much the rest of the energy may rise where a handle is closed. Above 5, bars of parts
  // that are sampled at their edges alone are cut.
  double max_closing_rise = 3;
  // Handles are those whose two sides meet after at most so many facets each; 0: none is closed.
  std::size_t most_handle_facets = 10000;
  // Nor is one at whose three samples more cells lie, since each flip changes what all of them
  // cost: at a sample with 9 000 cells that took 20 seconds. Those that were closed on 80 models
  // and scans have 250 at most.
  std::size_t most_closing_cells = 1000;
  double component_cost = 100;  // a part is dropped if it uses few samples: fewer than about 12
  // Hollows of which labels are known beforehand (known_hollows.h) are not filled, and are repaired
  // as all else is. Set by ReconstructOptions::keep_cavities.
  bool keep_hollows = false;
};

struct CleanUpCounters {
  std::size_t undecided_cells = 0;
  std::size_t thin_cells = 0;       // of those: with a good vertex
  std::size_t left_cells = 0;       // undecided, too, but in clumps that are too large
  std::size_t flat_cells = 0;       // among those that the cut labels
  std::size_t relabeled_cells = 0;  // by the cut, against the peel
  std::size_t filled_cells = 0;     // OUT cells shut off from infinity, now IN
  std::size_t moves = 0;
  std::size_t moved_cells = 0;
  std::size_t large_stars = 0;  // flawed samples left because of most_move_cells
  std::size_t clusters = 0;     // moved as a whole
  std::size_t cluster_cells = 0;
  std::size_t large_clusters = 0;  // idle samples with a cluster beyond most_cluster_cells
  std::size_t dropped_components = 0;
  std::size_t compound_moves = 0;
  std::size_t compound_cells = 0;
  std::size_t closed_handles = 0;
  std::size_t closing_cells = 0;  // that changed sides for it
  std::size_t large_handles = 0;  // left because of most_closing_cells
  std::size_t changed_cells = 0;  // that have another side now than after the peel
  // After the peel and at the end: what surface there is at vertices beyond one sheet (at both ends
  // of a non-manifold edge there is); unused samples.
  std::size_t defects_before = 0;
  std::size_t defects_after = 0;
  std::size_t unused_before = 0;
  std::size_t unused_after = 0;
  std::size_t outliers = 0;     // among those that the peel left out
  std::size_t idle_before = 0;  // idle samples before and after the clusters
  std::size_t idle_after = 0;
};

// Changes marks.reached, and marks.labels to what is known (CellMarks::known); nothing where every
// vertex is good and no marks conflict.
// Errors: InputError for parts of another triangulation, by their sizes, for marks that do not
// come from peel_cells, and for options out of range (inputs/stage_inputs.h). Complexity: passes
// over the cells, and near linear in the number of undecided cells and defects. Deterministic:
// costs are integers, the cut is unique, at each defect the best move is taken, at those of the
// densest samples first (SpacingCache::precedes); a function of the point set. Source: Labatut,
// Pons & Keriven 2009 (cut, facet quality); Kolluri, Shewchuk & O'Brien 2004 (poles as evidence);
// Amenta, Choi & Kolluri 2001 (its propagation). The moves are ours.
CleanUpCounters clean_up_cells(const Triangulation& triangulation, const Poles& poles,
                               CellMarks& marks, const CleanUpOptions& options = {},
                               const Execution& execution = {});

// Overload for callers that know a cell at each vertex: saves a pass over all cells. nullptr: not
// known.
CleanUpCounters clean_up_cells(const Triangulation& triangulation, const Poles& poles,
                               CellMarks& marks, const CleanUpOptions& options,
                               const IdVector<VertexId, CellId>* cell_at,
                               const Execution& execution = {});

}  // namespace cocoon
