// The first step of a reconstruction: points of any finite size to their triangulation.
#pragma once

#include "delaunay/delaunay.h"
#include "geom/execution.h"
#include "geom/point.h"

namespace cocoon {

// The Delaunay triangulation of working_scale(points) times the points. Progress: "delaunay".
// Complexity: that of delaunay(). Deterministic like it. Errors: InputError as delaunay(), and
// where scaling would lose bits, since the surface would be that of other points (reconstruct.h).
DelaunayResult triangulate_points(Points points, const DelaunayOptions& options = {},
                                  const Execution& execution = {});

}  // namespace cocoon
