// On which side of a closed mesh points lie, and how far from it.
#pragma once

#include <vector>

#include "geom/execution.h"
#include "geom/point.h"
#include "geom/triangle_mesh.h"

namespace cocoon {

// The distance of each point from the mesh: negative inside, positive outside, 0 on it. The sign is
// that of the angle-weighted normal at the closest point: of the facet, the edge (sum of the
// normals of its facets) or the vertex (normals weighted by the facets' angles there). It is right
// for every point if the mesh is closed, oriented outward and without self-intersections; for other
// meshes it is the side of the nearest facets. Facets without area have no normal. Throws
// InputError as ClosestFacetTree. Reports progress as "signed_distance". Complexity: O((p + t) log
// t). Deterministic for any thread count. Source: Baerentzen & Aanaes, Signed distance computation
// using the angle weighted pseudonormal (IEEE TVCG 11, 2005).
std::vector<double> signed_distances(const TriangleMesh& mesh, Points points,
                                     const Execution& execution = {});

}  // namespace cocoon
