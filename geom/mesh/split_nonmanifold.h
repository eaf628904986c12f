// From a closed surface that touches itself along edges or in vertices to a 2-manifold.
//
// Where bodies only touch (four triangles at an edge, two fans at a vertex) the surface stays where
// it is, but each sheet gets vertices of its own:
//
//   edge    its triangles are sorted around it, and the two that bound one wedge of the inside stay
//           together: the inside is cut apart there, the outside passes through
//   vertex  one copy for each fan of triangles that hang together by such pairs
//   seam    an edge both of whose ends lie in one fan is still shared by two pairs, since copies of
//           its ends would not tell them apart (a body that touches itself): all but one pair get
//           the midpoint of the edge as a new vertex, which cuts their triangles in two
#pragma once

#include <cstddef>

#include "geom/id_vector.h"
#include "geom/triangle_mesh.h"

namespace cocoon {

struct SplitSurface {
  // The vertices of the input with their ids, then copies, then midpoints. Triangles in canonical
  // order (geom/triangle_mesh.h).
  TriangleMesh mesh;
  // The vertex of the input whose attributes each vertex takes: the one it copies; of a midpoint
  // the lexicographically smaller end of its edge.
  IdVector<VertexId, VertexId> source;
  std::size_t split_edges = 0;     // had more than two triangles
  std::size_t split_vertices = 0;  // have copies
  std::size_t copies = 0;
  std::size_t midpoints = 0;
  std::size_t unpaired_halfedges = 0;  // at such edges, where as many triangles do not run each way
};

// Splits `mesh`: no edge of the result has more than two triangles, no vertex is pinched, and every
// point of the surface stays in place (midpoints are rounded). A balanced mesh (geom/mesh_check.h)
// stays balanced, so one that bounds a body becomes a closed oriented 2-manifold. Of a manifold
// only the order of triangles may change. Triangles that run through an edge of three or more
// without a partner keep an open edge there, and are counted. Copies have equal coordinates:
// formats without ids (STL) cannot tell them apart. Errors: InputError if a triangle names a vertex
// that is not there or one vertex twice. Preconditions: finite coordinates; triangles at such an
// edge have an area. Complexity: O(t + v) and sorts of small lists. Deterministic: exact angular
// order; ties by coordinates. Source: docs/stages/split_nonmanifold.md.
SplitSurface split_nonmanifold(const TriangleMesh& mesh);

}  // namespace cocoon
