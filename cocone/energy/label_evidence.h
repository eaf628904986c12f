// Whether an undecided cell is OUT or IN, told by the balls around the cells.
//
// The circumballs of a sample's cells approximate the medial axis from both sides. Two rules carry
// what is known to what is not, both with a weight between 0 and 1:
//
//   deep balls agree:     balls that meet across a facet under the angle beta have the same label,
//                         weight cos(beta); 1 for equal balls, 0 and below for touching ones
//   opposite poles differ: the two poles c, d of a sample s have different labels, weight
//                         -cos(angle c s d) times the trust t + (1 - t) g in s. t grows from 0 to 1
//                         as the nearer pole is near_pole_ratio to full_pole_ratio spacings off, g
//                         from 0 to 1 as the share of good samples among the corners around is up
//                         to pole_good_share: in a layer of noise both poles have one label
//
// Flat cells (ball_cosines.h) have no say and are no poles; balls meet through them.
// Infinity is OUT and decided cells have their label, both with weight 1; infinite
// cells tell that to opposite poles only, having no balls. Thin cells (doubtful_region.h) have that
// of theirs with weight mark_credit (all these are options of clean_up_cells.h), but none at
// vertices where labels are in conflict: good vertices are not always right there.
#pragma once

#include "cocone/cell_marks.h"
#include "cocone/clean_up_cells.h"
#include "cocone/energy/ball_cosines.h"
#include "cocone/energy/doubtful_region.h"
#include "cocone/poles.h"
#include "cocone/samples/sample_spacing.h"
#include "delaunay/star_cache.h"
#include "delaunay/triangulation.h"
#include "geom/arrays/zeroed_array.h"
#include "geom/execution.h"
#include "geom/point.h"

namespace cocoon {

// Evidence for a cell: weights of the strongest chains of rules that say OUT and IN.
struct LabelEvidence {
  float out = 0;
  float in = 0;
};

// Evidence for the undecided cells of the region (all others: zero); `marks.labels` of the others
// are taken for granted, and what has none for IN. The weight of a chain is the product of its
// rules' weights. Cells are settled in the order of how clear their evidence is (power crust):
// uncontested ones and large |out - in| first, and pass on the stronger label. Ties go to the
// smaller corners in the order of the region's vertices: a function of the point set. `cosines`,
// `centers`: prepared for the cells of the region (BallCosines::prepare); `spacings`: asked for
// those of the undecided cells' samples. Complexity: O(u log u) for u undecided cells, and three
// passes over the stars of their vertices, parallel. Source: Amenta, Choi & Kolluri 2001 (the power
// crust, labeling of poles); the trust is ours.
ZeroedArray<CellId, LabelEvidence> label_evidence(
    const Triangulation& triangulation, StarCache& stars, BallCosines& cosines,
    const ZeroedArray<CellId, Point>& centers, SpacingCache& spacings, const Poles& poles,
    const CellMarks& marks, const DoubtfulRegion& region, const CleanUpOptions& options,
    const Execution& execution = {});

}  // namespace cocoon
