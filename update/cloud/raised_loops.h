// Loops of a rim that lie farther from the model than its outline does.
#pragma once

#include "geom/ids.h"
#include "update/cloud_rim.h"
#include "update/model/model_index.h"
#include "update/overlapping_facets.h"

namespace cocoon {

// The larger one of the rim's spacing and the model's at a facet (its median edge). O(1).
double larger_spacing(const ModelIndex& model, const CloudRim& rim, TriangleId facet);

// Fills in OverlapFigures::largest_excess. Precondition: the median distance, facets and feet are
// known. Complexity: O(rim).
void measure_excess(const ModelIndex& model, const CloudRim& rim, Overlap& overlap);

// Fills in LoopOverlap::is_outline and raised: points farther from the model by `raised_distance`
// larger spacings than the outline of their part of the surface is in the median, or than the
// longest loop of all is, whichever is less; points without a facet, too. Precondition as above.
// Complexity: O(rim log rim). Source: ours, docs/update.md, departure 26.
void count_raised(const ModelIndex& model, const CloudRim& rim, double raised_distance,
                  Overlap& overlap);

// Whether too much of a loop is raised for it to lie on the model (OverlapOptions). Points on other
// clouds are excused. Never true of the longest loop of all, of which no point is raised. O(1).
bool is_raised(const LoopOverlap& loop, const OverlapOptions& options);

}  // namespace cocoon
