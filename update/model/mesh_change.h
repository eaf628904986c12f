// What an update changed in a mesh.
#pragma once

#include <vector>

#include "geom/id_vector.h"
#include "geom/ids.h"
#include "geom/triangle_mesh.h"

namespace cocoon {

struct MeshChange {
  IdVector<VertexId, VertexId> vertex_map;  // each old vertex in the new mesh; none: it is gone
  IdVector<TriangleId, TriangleId> triangle_map;  // each old triangle likewise
  std::vector<Triangle> removed;  // by old vertices, in canonical order: not in the new mesh
  std::vector<Triangle> added;    // by new vertices, in canonical order: not in the old mesh
  bool empty() const { return removed.empty() && added.empty(); }
};

// The triangles in which two meshes differ; a triangle is the same if its vertices are, up to
// rotation. Triangles that occur several times count as often as they do.
// Complexity: O(t), and t log t where triangles are not in canonical order.
MeshChange mesh_change(const TriangleMesh& before, const TriangleMesh& after,
                       IdVector<VertexId, VertexId> vertex_map);

}  // namespace cocoon
