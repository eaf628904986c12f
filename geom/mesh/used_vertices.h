// Which vertices of a mesh are in its triangles.
#pragma once

#include <cstdint>

#include "geom/id_vector.h"
#include "geom/ids.h"
#include "geom/triangle_mesh.h"

namespace cocoon {

// 1 for vertices that a triangle has. Precondition: they are there. Complexity: O(v + t).
IdVector<VertexId, std::uint8_t> used_vertices(const TriangleMesh& mesh);

// Leaves out the others; those that stay keep their order. Returns what each is now; none: it went.
// Precondition and complexity: the same.
IdVector<VertexId, VertexId> leave_out_unused(TriangleMesh& mesh);

}  // namespace cocoon
