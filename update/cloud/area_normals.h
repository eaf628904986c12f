// Normals of the vertices of an oriented surface, weighted by area.
#pragma once

#include <cstdint>

#include "geom/id_vector.h"
#include "geom/point.h"
#include "geom/triangle_mesh.h"

namespace cocoon {

// Unit normals of the vertices whose flag is set: of the sum of their triangles' normals, each as
// long as its triangle is large. Zero for the others, and where the sum is zero. The triangles must
// be oriented. Complexity: O(triangles + vertices).
IdVector<VertexId, Vec3> area_normals(const TriangleMesh& mesh,
                                      const IdVector<VertexId, std::uint8_t>& wanted);

}  // namespace cocoon
