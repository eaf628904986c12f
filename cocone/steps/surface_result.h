// The last steps of a reconstruction: from the mesh of a surface to the result, and its
// verification.
#pragma once

#include "cocone/reconstruct.h"
#include "cocone/steps/find_surface.h"
#include "cocone/surface_mesh.h"
#include "geom/execution.h"
#include "geom/id_vector.h"
#include "geom/ids.h"

namespace cocoon {

struct SurfaceResult {
  ReconstructResult result;
  IdVector<VertexId, VertexId> triangulation_vertex;  // of each vertex of the mesh
};

// Of no surface yet. Complexity: O(1). Errors: InputError if the triangulation is one of another
// number of points.
SurfaceResult begin_result(const ReconstructInput& input);

// Enters a mesh, with the user's coordinates and what is known of its samples, and the status: `ok`
// unless it is empty. Complexity: O(vertices), parallel.
void enter_mesh(const ReconstructInput& input, const FoundSurface& found, SurfaceMesh mesh,
                SurfaceResult& made, const Execution& execution);

enum class SurfaceKind { closed, open };

// If the options ask for it, and there is a surface, which is to be of that kind. What is refuted
// is taken back. Errors and complexity: those of verify_surface().
void verify_result(const ReconstructInput& input, SurfaceKind kind, SurfaceResult& made,
                   const Execution& execution);

}  // namespace cocoon
