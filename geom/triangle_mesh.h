// A triangle mesh as plain data. Adjacency, checks and measures are computed from it by the other
// files of this folder; nothing is cached in it.
#pragma once

#include <array>

#include "geom/id_vector.h"
#include "geom/point.h"

namespace cocoon {

// Three vertices, counterclockwise seen from outside.
using Triangle = std::array<VertexId, 3>;

struct TriangleMesh {
  IdVector<VertexId, Point> points;
  IdVector<TriangleId, Triangle> triangles;

  friend bool operator==(const TriangleMesh&, const TriangleMesh&) = default;
};

// Rotates every triangle so that its smallest vertex id comes first, then sorts the triangles:
// equal surfaces become equal arrays. Orientation is kept.
// Precondition: triangles name vertices that are there. Complexity: O(t + v) for bounded valence.
void canonicalize_triangles(TriangleMesh& mesh);

}  // namespace cocoon
