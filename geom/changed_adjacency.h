// The adjacency of a closed mesh after a change of some of its triangles.
#pragma once

#include <optional>
#include <vector>

#include "geom/id_vector.h"
#include "geom/ids.h"
#include "geom/mesh_adjacency.h"
#include "geom/triangle_mesh.h"

namespace cocoon {

// A mesh and its neighbors (mesh_neighbors) before a change, and where its vertices and triangles
// are now; none: gone. A triangle that stays has the same corners, maybe turned.
struct MeshBefore {
  const TriangleMesh& mesh;
  const MeshAdjacency& adjacency;
  const IdVector<VertexId, VertexId>& vertex_map;
  const IdVector<TriangleId, TriangleId>& triangle_map;
};

struct ChangedAdjacency {
  MeshAdjacency adjacency;  // mesh_neighbors(mesh)
  // The new triangles, and the old ones that got another neighbor; ascending.
  std::vector<TriangleId> seam;
};

// Only the sides where triangles went or came are linked anew. Nothing, if a side of either mesh
// does not meet exactly one other there: then only the whole tells. Complexity: O(t + v), a copy in
// new numbers.
std::optional<ChangedAdjacency> changed_neighbors(const TriangleMesh& mesh,
                                                  const MeshBefore& before);

}  // namespace cocoon
