// On which side of a closed mesh points lie, and how far from it.
#pragma once

#include <vector>

#include "geom/execution.h"
#include "geom/point.h"
#include "geom/triangle_mesh.h"

namespace cocoon {

// The distance of each point from the mesh: negative inside, positive outside, 0 on it. Of a closed
// mesh (balanced: mesh_check.h) points with another winding number than 0 are inside, exactly,
// whichever way it is oriented (winding_number.h). Of other meshes the sign is that of the
// angle-weighted normal at the closest point, so that it is the side of the nearest facets: of the
// facet, the edge (sum of the normals of its facets) or the vertex (normals weighted by the facets'
// angles there); facets without area have no normal, and those nearly so none to rely on.
// Coordinates may have any size: distances are relative to the larger of mesh and points.
// Throws InputError as ClosestFacetTree. Reports progress as "signed_distance". Complexity: O((p +
// t) log t) expected. Deterministic for any thread count. Source of the normals: Baerentzen &
// Aanaes, Signed distance computation using the angle weighted pseudonormal (IEEE TVCG 11, 2005).
std::vector<double> signed_distances(const TriangleMesh& mesh, Points points,
                                     const Execution& execution = {});

}  // namespace cocoon
