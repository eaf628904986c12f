// Takes away the long triangles with which an open Cocone surface bridges slots and holes.
#pragma once

#include <cstddef>

#include "geom/mesh/halfedges.h"
#include "geom/triangle_mesh.h"

namespace cocoon {

struct TrimOptions {
  // An edge longer than this many local spacings is long; 0 = no trimming, as in the paper. The
  // spacing at an edge is the smaller one of its ends; at a vertex the lower quartile of its edge
  // lengths, smoothed to the median over the vertex and its neighbors.
  double max_edge = 5;
  // Triangles with a long edge go where they reach the rim with it, and elsewhere only in
  // edge-connected clusters of at least this many: a hole that was bridged.
  std::size_t min_cluster = 3;
};

struct TrimmedSurface {
  TriangleMesh mesh;            // all vertices, fewer triangles, in the same order
  HalfedgeRings rings;          // of that mesh
  std::size_t at_rim = 0;       // triangles taken away from the rim inwards
  std::size_t in_clusters = 0;  // triangles taken away in clusters
};

// Clusters go first, then triangles whose long edge has no other triangle, until there is none.
// Spacings are those of the untrimmed surface, so the order does not matter.
// Why: undersampling is detected relative to the local feature size, not to the spacing. A flat
// cloud has no feature, so a slot or hole in it is bridged at any rho (longest edge 5 to 38 medians
// at rho 0.83, 1 to 8 at 0.13). Complexity: O(triangles): the spacing is looked at only
// where an edge is long beside the shortest one around.
// Errors: InputError for options out of range. Source: ours; not in Woo & Dey 2005.
TrimmedSurface trim_long_edges(TriangleMesh surface, const TrimOptions& options = {});

}  // namespace cocoon
