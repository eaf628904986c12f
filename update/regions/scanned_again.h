// Which vertices of the model amid new samples are the surface that was scanned.
#pragma once

#include <span>
#include <vector>

#include "geom/ids.h"
#include "geom/search/nearest_point.h"
#include "update/cloud/outward_normals.h"
#include "update/model/model_index.h"

namespace cocoon {

// Those of `vertices` whose nearest sample does not face the other way, as that of the far side of
// a thin wall does; of several clouds whose samples are as near, not all of these. Samples whose
// normal is not known face no way. clouds[c]: the samples of which outward(c) tells. Errors:
// InputError unless it tells of all of them. Complexity: O(k log n) for k vertices, and what
// `outward` takes. Deterministic, whatever the order of the clouds. Source: ours,
// docs/departures.md, departure 36.
std::vector<VertexId> scanned_again(const ModelIndex& model, std::span<const VertexId> vertices,
                                    std::span<const NearestPointTree> clouds,
                                    const OutwardNormals& outward);

}  // namespace cocoon
