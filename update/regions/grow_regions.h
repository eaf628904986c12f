// The parts into which a border cuts the facets of a model.
#pragma once

#include "update/model/model_index.h"
#include "update/model/triangle_set.h"
#include "update/segment_model.h"

namespace cocoon {

// Regions by lowest facets, with `first`, `facets` and region_of_facet; the rest is left empty.
// Facets of the border are in none. In a connected model all regions grow at the same pace from
// the border, and the last one need not be walked through: it is what is left.
// Complexity: O(t); in a connected model, besides a pass over the facets, in proportion to the
// regions without the largest.
Regions grow_regions(const ModelIndex& model, const TriangleSet& border);

}  // namespace cocoon
