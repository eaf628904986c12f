// Triangles that a mesh has more than once, as some programs write them: single faces written
// twice, whole bodies twice, sheets with both of their sides.
#pragma once

#include <cstddef>
#include <span>

#include "geom/execution.h"
#include "geom/search/equal_points.h"
#include "geom/triangle_mesh.h"

namespace cocoon {

// Leaves out triangles whose corners are at the places of those of an earlier one, in any order;
// the others stay in their order. Those that hang together by edges go or stay together: they stay
// if the edges of an odd number of triangles would be more without them, as where two bodies have a
// wall in common, or where a wall without thickness ends. So no closed body is opened. Returns how
// many went; vertices that no triangle uses any more stay. `repeated`: repeated_points of the
// vertices. Preconditions: triangles name vertices that are there. Complexity: O(v + t) for
// bounded valence, parallel, and O(k log k) for k triangles that are repeated. Deterministic.
// Source: ours.
std::size_t leave_out_repeated_triangles(TriangleMesh& mesh,
                                         std::span<const RepeatedPoint> repeated,
                                         const Execution& execution = {});

}  // namespace cocoon
