// How far the loops of a rim lie from the model, and which lie farther than the outline does.
#pragma once

#include "geom/ids.h"
#include "update/cloud_rim.h"
#include "update/model/model_index.h"
#include "update/overlapping_facets.h"

namespace cocoon {

// The larger one of the rim's spacing and the model's at a facet (its median edge). O(1).
double larger_spacing(const ModelIndex& model, const CloudRim& rim, TriangleId facet);

// Fills in OverlapFigures::largest_excess. Precondition: the median distance, facets and feet are
// known. Complexity: O(rim). Source: ours, docs/departures.md, departure 23.
void measure_excess(const ModelIndex& model, const CloudRim& rim, Overlap& overlap);

// Fills in LoopOverlap::is_outline and raised: points of outlines that are farther from the model,
// by `raised_distance` larger spacings, than the longest loop of all is in the median; points of
// other loops that are so much farther than that and than the outline of their part of the surface;
// and points without a facet. Precondition as above. Complexity: O(rim log rim). Source: ours,
// docs/departures.md, departure 26.
void count_raised(const ModelIndex& model, const CloudRim& rim, double raised_distance,
                  Overlap& overlap);

// Whether too much of a loop is raised for it to lie on the model (OverlapOptions). Points on other
// clouds are excused. Never true of the longest loop of all, of which no point is raised. O(1).
bool is_raised(const LoopOverlap& loop, const OverlapOptions& options);

}  // namespace cocoon
