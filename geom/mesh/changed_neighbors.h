// The neighbors of triangles of a closed mesh after a change of some of these.
//
// Use this where the neighbors before the change are at hand, which costs less than
// triangle_neighbors().
#pragma once

#include <optional>
#include <vector>

#include "geom/id_vector.h"
#include "geom/ids.h"
#include "geom/mesh/triangle_neighbors.h"
#include "geom/mesh/triangles_at_vertices.h"
#include "geom/triangle_mesh.h"

namespace cocoon {

// A mesh and its neighbors before a change, and where its vertices and triangles are now; none:
// gone. A triangle that stays has the same corners, maybe turned.
struct MeshBefore {
  const TriangleMesh& mesh;
  const TriangleNeighbors& neighbors;
  const IdVector<VertexId, VertexId>& vertex_map;
  const IdVector<TriangleId, TriangleId>& triangle_map;
};

struct ChangedNeighbors {
  TriangleNeighbors neighbors;      // triangle_neighbors(mesh)
  TrianglesAtVertices at_vertices;  // triangles_at_vertices(mesh)
  // The new triangles, and the old ones that got another neighbor; ascending.
  std::vector<TriangleId> seam;
};

// Only the edges where triangles went or came are linked anew. Nothing, if an edge of either mesh
// does not have exactly two triangles: then only the whole tells. Complexity: O(t + v), a copy in
// new numbers.
std::optional<ChangedNeighbors> changed_neighbors(const TriangleMesh& mesh,
                                                  const MeshBefore& before);

}  // namespace cocoon
