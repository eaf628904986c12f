// The Voronoi cell of one vertex: a convex polyhedron, face by face.
#pragma once

#include <vector>

#include "delaunay/triangulation_view.h"

namespace cocoon {

// The part of the Voronoi cell's surface that is as near to `neighbor` as to the vertex: dual to
// the edge between them.
struct VoronoiFace {
  VertexId neighbor;
  // Its corners: the cells around the edge, counterclockwise seen from the neighbor, beginning with
  // the smallest id. A corner is the circumcenter of a finite cell (voronoi_dual, circumsphere.h);
  // an infinite cell stands for the direction in which the face goes to infinity, and an unbounded
  // face has two of them, one after the other. Corners may coincide (cospherical points).
  std::vector<CellId> corners;
};

struct VoronoiCell {
  std::vector<VoronoiFace> faces;  // by increasing neighbor
  bool is_bounded = true;          // the vertex is not on the convex hull
};

// `cell`: one of the cells at v (VertexStars::star, DynamicDelaunay::cell_at), else InputError.
// Complexity: O(size of the star) expected, and sorting.
VoronoiCell voronoi_cell(const TriangulationView& triangulation, VertexId v, CellId cell);

}  // namespace cocoon
