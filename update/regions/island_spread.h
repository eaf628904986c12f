// From facets of an island to the others near them.
#pragma once

#include <vector>

#include "geom/ids.h"
#include "update/model/model_index.h"
#include "update/model/triangle_set.h"

namespace cocoon {

// Adds to `facets`, ascending, those at most `reach` from one of them (centroids) that hang
// together with it by edges without settled ones (of the border, or under the cloud: 1), if all
// these together are an island: no more than half of the facets that are not settled; and if more
// than `min_share` of the island's facets are among `facets`. Why: around the floor of a pocket
// whose walls were not seen a strip is left between the floor and the loop around the mouth;
// without it there would be a wall of old facets. Errors: InputError for flags of another model, by
// their sizes. Complexity: O(triangles), and O(log n) for each facet of an island. Source: ours.
void spread_on_islands(const ModelIndex& model, TriangleSet settled, double reach, double min_share,
                       std::vector<TriangleId>& facets);

}  // namespace cocoon
