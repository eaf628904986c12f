// Where clouds overlap each other: which parts of a rim another cloud goes on beyond.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "update/cloud/scan.h"
#include "update/cloud_rim.h"

namespace cocoon {

struct SharedEdgeOptions {
  // A rim edge is shared with another cloud that has a sample within `reach` spacings of the point
  // one spacing outward from its midpoint, as in RimSeamOptions. The spacing is the larger one of
  // the rim's and the other cloud's.
  double reach = 0.85;
};

// Marks the edges of `rim`, that of scans[c], that are shared as inner ones (RimLoop::inner) and
// counts those that were none (CloudRim::shared_edges). Returns the other clouds with such samples,
// in increasing order. Errors: InputError if there is no scan c, and for options out of range. Why:
// what several scans that overlap each other show ends where all of them end. The rim of one in the
// midst of another tells nothing about the model, whether it is near it or far away. Complexity:
// O(samples + clouds * rim edges + m log m) for the m rim edges and samples near each other.
// Deterministic. Source: ours; clouds that overlap each other do not occur in Woo & Dey 2005.
std::vector<std::size_t> mark_shared_edges(std::size_t c, std::span<const Scan> scans,
                                           CloudRim& rim, const SharedEdgeOptions& options = {});

// The lowest cloud among those that hang together with each by shared edges; others[c]: the clouds
// that mark_shared_edges() found for c. Complexity: near linear in the entries.
std::vector<std::size_t> lowest_sharing_clouds(std::span<const std::vector<std::size_t>> others);

}  // namespace cocoon
