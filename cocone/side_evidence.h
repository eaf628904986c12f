// On which side of the surface an undecided cell lies, told by the balls around the cells.
//
// The circumballs of a sample's cells approximate the medial axis from both sides. Two rules carry
// what is known to what is not, both with a weight between 0 and 1:
//
//   deep balls agree:     balls that meet across a facet under the angle beta have the same side,
//                         weight cos(beta); 1 for equal balls, 0 and below for touching ones
//   opposite poles differ: the two poles c, d of a sample s lie on different sides, weight
//                         -cos(angle c s d)
//
// Infinity is OUT with weight 1, and so are the cells that the marking decided.
#pragma once

#include <cstddef>
#include <vector>

#include "cocone/mark_cells.h"
#include "cocone/poles.h"
#include "delaunay/star_cache.h"
#include "delaunay/triangulation.h"
#include "delaunay/voronoi_dual.h"
#include "geom/zeroed_array.h"

namespace cocoon {

// For facet f seen from its cell: the cosine of the angle between the facet and the tangent plane
// of the cell's ball at the facet's circle; 1 if the ball is a half-space beyond the facet (as for
// an infinite cell), -1 if it is one on the other side. O(1).
double ball_cosine(const Triangulation& triangulation, const Dual& dual, FacetId f);

// The cosine of the angle at which the balls of the two cells of a facet meet: 1 for equal balls, 0
// if their surfaces cross at right angles, -1 if they touch. The same from both sides. O(1).
double contact_cosine(const Triangulation& triangulation, const Dual& dual, FacetId f);

// Evidence for a cell: weights of the strongest chains of rules that say OUT and IN.
struct SideEvidence {
  float out = 0;
  float in = 0;
};

// Evidence for the cells of `undecided` (all others: zero); `marks.labels` of the others are taken
// for granted. The weight of a chain is the product of its rules' weights. Cells are settled in the
// order of how clear their evidence is (power crust): |out - in| large and uncontested first, and
// pass on their stronger side. Ties go to the lexicographically smaller corners: a function of the
// point set. Complexity: O(d log d) for d cells at vertices of undecided cells.
// Source: Amenta, Choi & Kolluri 2001 (the power crust, labeling of poles).
ZeroedArray<CellId, SideEvidence> side_evidence(const Triangulation& triangulation,
                                                const Dual& dual, StarCache& stars,
                                                const Poles& poles, const CellMarks& marks,
                                                const std::vector<CellId>& undecided);

}  // namespace cocoon
