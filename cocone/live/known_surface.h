// The mesh of a surface that is known.
#pragma once

#include "cocone/live/surface_state.h"
#include "cocone/surface_mesh.h"
#include "delaunay/triangulation.h"
#include "geom/execution.h"

namespace cocoon {

// That of the certified surface, or of the body's boundary: the one that the stages gave.
// Precondition: state.has_surface(), and check_surface_state finds no fault. Complexity: O(cells),
// parallel.
SurfaceMesh known_surface(const Triangulation& triangulation, const SurfaceState& state,
                          const Execution& execution = {});

}  // namespace cocoon
