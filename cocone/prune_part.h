// Pruning on a part of the candidates.
#pragma once

#include <cstdint>
#include <vector>

#include "cocone/facet_set.h"
#include "cocone/linked_facets.h"
#include "cocone/prune_sharp_edges.h"

namespace cocoon {

// One flag per triangle: 1 = prune_sharp_edges would remove it, as far as the edges with a vertex
// of `core` tell; all triangles at these vertices must be there. `umbrella`: of all vertices.
// Triangles with one core vertex have an edge that is not looked at. If each of them ends as it did
// when the whole was pruned, before something changed at core vertices only, then the flags, and
// what is known of all other triangles, are together what pruning the whole gives: what is removed
// here is removed without help from outside, and what is not stays by the triangles that stay.
// Complexity: O(triangles).
std::vector<std::uint8_t> prune_part(const LinkedFacets& triangles, const VertexSet& core,
                                     const VertexSet& umbrella, const PruneOptions& options = {});

}  // namespace cocoon
