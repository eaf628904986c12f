// Vertices of a mesh that are at equal places, taken as one: files whose triangles share no
// vertices become a surface.
#pragma once

#include <cstddef>
#include <span>

#include "geom/id_vector.h"
#include "geom/search/equal_points.h"
#include "geom/triangle_mesh.h"

namespace cocoon {

struct WeldedMesh {
  TriangleMesh mesh;                       // vertices and triangles in their order
  IdVector<VertexId, VertexId> vertex_of;  // of each vertex of the input, the one that it became
  IdVector<VertexId, VertexId> source;     // of each vertex of `mesh`, the first that became it
  std::size_t welded = 0;                  // vertices at the place of an earlier one
  std::size_t left_out_triangles = 0;      // two of their corners became one
};

// Welds exactly: equal coordinates (0 and -0 are), no tolerance. Triangles that are equal then stay
// both. `repeated`: repeated_points of the vertices. Preconditions: finite coordinates; triangles
// name vertices that are there. Complexity: O(v + t). Deterministic: a function of the mesh.
WeldedMesh weld_vertices(const TriangleMesh& mesh, std::span<const RepeatedPoint> repeated);

}  // namespace cocoon
