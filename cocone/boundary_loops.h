// Boundary loops: the rim of an open surface as closed walks.
//
// A boundary edge has exactly one triangle. Around one of its ends the triangles form a fan that
// ends at another boundary edge: its successor. Every boundary edge is so paired once at each end,
// hence the edges fall into closed loops, also where a vertex is visited twice.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "geom/mesh/edge_components.h"
#include "geom/mesh/halfedges.h"
#include "geom/triangle_mesh.h"

namespace cocoon {

struct BoundaryEdge {
  VertexId from;  // the edge in the direction of its triangle: the surface lies to the left,
  VertexId to;    // seen from outside
  TriangleId triangle;
};

struct BoundaryLoop {
  std::vector<BoundaryEdge> edges;  // edges[i].to == edges[i + 1].from, cyclically
  double perimeter = 0;
  bool pin_hole = false;                // too small to be a rim, see the options
  std::size_t component_triangles = 0;  // of the edge-connected part of the surface it bounds
  std::uint32_t component = 0;          // the same number for all loops of that part
};

struct BoundaryLoopOptions {
  // Parts of the surface with a smaller share of its triangles are debris: their loops are not
  // listed.
  double min_component_share = 0.05;
  // A loop with fewer edges, or a perimeter below this many median edges of the surface, is listed
  // as a pin-hole.
  std::size_t min_loop_edges = 8;
  double min_perimeter_in_edges = 12;
};

struct BoundaryLoops {
  std::vector<BoundaryLoop> loops;    // by their first points
  std::size_t pin_holes = 0;          // among the loops
  std::size_t small_components = 0;   // parts of the surface below the share
  std::size_t discarded_loops = 0;    // of these parts
  std::size_t surplus_triangles = 0;  // not looked at: third and further ones at an edge
  std::size_t non_orientable = 0;     // components without a consistent orientation
  double median_edge = 0;             // length, over all edges of the surface

  // The loops that are rims.
  std::size_t rims() const { return loops.size() - pin_holes; }
};

// The loops of `open_surface`, whose triangles may be oriented in any way. First, at an edge with
// three or more triangles all but the flattest pair are left out, repeated until there is no such
// edge; then the others are oriented per component (orient_surface.h). Triangle ids are those of
// `open_surface`. Each loop begins at the edge with the lexicographically smallest starting point.
// Result: no loop if the surface is closed or empty. Errors: InputError as link_halfedges(),
// and unless the share is one (0 to 1) and the perimeter 0 or more.
// Complexity: O(triangles + vertices + rim log rim + k^2 for k > 2 triangles at one edge).
// Independent of the numbering of the mesh. Source: Woo & Dey 2005, section 3.2. There a boundary
// edge joins two boundary samples; that also returns chords across corners and misses edges whose
// end was taken for interior, so the combinatorial definition is used
// (docs/stages/boundary_loops.md).
BoundaryLoops boundary_loops(const TriangleMesh& open_surface,
                             const BoundaryLoopOptions& options = {});

// Overload for callers that already have the linked halfedges of the surface, and have oriented it
// by orient_surface() with these components. Errors: InputError for those of another mesh, by their
// sizes.
BoundaryLoops boundary_loops(const TriangleMesh& oriented_surface, const HalfedgeRings& rings,
                             const EdgeComponents& components,
                             const BoundaryLoopOptions& options = {});

}  // namespace cocoon
