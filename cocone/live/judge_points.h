// What the stages find of each point, without a surface.
#pragma once

#include "cocone/reconstruct.h"
#include "delaunay/triangulation.h"

namespace cocoon {

// Appends the normal of each input point, and whether it is a boundary sample, in their order: as
// reconstruct_tight() finds them with these options. Complexity: O(n).
void judge_points(const Triangulation& triangulation, const ReconstructOptions& options,
                  ReconstructResult& result);

}  // namespace cocoon
