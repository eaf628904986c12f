// The triangles across the edges of each triangle of a mesh.
//
// Use this to go from triangle to triangle, flooding or walking, where it does not matter who else
// is at an edge. For that see halfedges.h; after a change of a few triangles, changed_neighbors.h.
#pragma once

#include <array>

#include "geom/execution.h"
#include "geom/id_vector.h"
#include "geom/ids.h"
#include "geom/triangle_mesh.h"

namespace cocoon {

// neighbors[t][i]: the triangle across the edge opposite corner i of t; `none` where there is no
// other triangle or more than one, and in a triangle that repeats a vertex: it has no edges.
using TriangleNeighbors = IdVector<TriangleId, std::array<TriangleId, 3>>;

// Throws InputError as require_valid_triangles(). Complexity: O(t + v), parallel. Deterministic.
TriangleNeighbors triangle_neighbors(const TriangleMesh& mesh, const Execution& execution = {});

}  // namespace cocoon
