// Pruning on a part of a triangulation.
#pragma once

#include <cstdint>
#include <optional>

#include "cocone/facet_set.h"
#include "cocone/local_patch.h"
#include "cocone/prune_sharp_edges.h"
#include "geom/execution.h"
#include "geom/id_vector.h"

namespace cocoon {

// The candidates that prune_sharp_edges would leave of those at the core of the patch, where
// `known` (bit i of a slot: facet i was pruned) tells how it was before, and still is off the core.
// Looks at edges with a core vertex, which are complete. None if a core vertex has no umbrella, or
// if what happens at the rim differs from what is known there: then more than the core changes.
// Precondition: vertices off the core have umbrellas. Complexity: O(cells of the patch).
std::optional<FacetSet> prune_patch(const LocalPatch& patch, const FacetSet& candidates,
                                    const IdVector<CellId, std::uint8_t>& known,
                                    const PruneOptions& options = {},
                                    const Execution& execution = {});

}  // namespace cocoon
