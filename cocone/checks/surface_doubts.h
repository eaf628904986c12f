// Where a surface should not be believed: what its samples and triangles say about themselves.
#pragma once

#include <cstddef>
#include <vector>

#include "cocone/reconstruct.h"
#include "geom/execution.h"
#include "geom/mesh_check.h"
#include "geom/point.h"

namespace cocoon {

// A place to look at.
struct DoubtfulSpot {
  Point at;
  std::size_t count = 0;  // samples, triangles: what there is of it
  double size = 0;        // in units of the coordinates, see the lists

  friend bool operator==(const DoubtfulSpot&, const DoubtfulSpot&) = default;
};

// Leaves that many of the largest size, the largest first; ties go to the lexicographically smaller
// place. Complexity: O(n log count).
void keep_largest(std::vector<DoubtfulSpot>& spots, std::size_t count);

struct SurfaceDoubtOptions {
  std::size_t max_spots = 3;     // of each list
  double gap_ratio = 4;          // longest edge at a vertex over the median of its edges: a gap
  double fragment_share = 0.01;  // of the triangles of the largest component: smaller ones are dust
  bool place_handles = true;     // whether `handles` is asked for
};

struct SurfaceDoubts {
  double spacing = 0;  // median length of the surface's edges
  // Median over the vertices of the distance to the mean of their neighbors, along the normal of
  // the triangles, divided by the mean distance to them: 0.7 times the deviation of normal noise in
  // units of the spacing, where curvature does not matter.
  double roughness = 0;
  std::size_t boundary_samples = 0;  // among the vertices
  std::size_t gap_samples = 0;       // vertices at a gap
  std::vector<DoubtfulSpot> sparse;  // groups of both joined by edges; count: samples, at: the
                                     // one with the longest edge, size: that edge
  std::size_t fragments = 0;         // components with few triangles
  std::vector<DoubtfulSpot> dust;    // the largest of them; count: triangles, size: of its box
  std::size_t unused_points = 0;     // input points that no triangle uses (equal ones count once)
  std::vector<DoubtfulSpot> unused;  // farthest from the vertices; size: the distance
  std::size_t bad_edges = 0;         // with more than two triangles
  std::size_t pinched_vertices = 0;
  std::vector<DoubtfulSpot> contacts;  // some ends of such edges and pinched vertices; size: 0
  // The narrowest first, if some sample is unsurrounded; count: edges around it, size: their length
  // (narrow_handles.h). With contacts there is no genus, and none are told.
  std::vector<DoubtfulSpot> handles;
  MeshReport certificate;  // mesh_check of the surface
  // Of the stages that made the surface, not of its triangles (ReconstructCounters):
  std::size_t samples = 0;               // vertices of the triangulation
  std::size_t unsurrounded_samples = 0;  // without one disk of Cocone triangles around them
  std::size_t conflicts = 0;             // where marks of inside and outside met (mark_cells.h)
  // Groups of vertices that are contradicted, joined by edges; as `sparse`, but by their counts.
  std::vector<DoubtfulSpot> contradicted;
};

// What is doubtful about a reconstruction of `points`; empty meshes: zeros. Lists have the worst
// first, ties by coordinates. Complexity: O(n log n), O(n) if all points are used, measures and
// most checks parallel. Deterministic: a function of the point set and the surface. Errors:
// InputError for fewer points than the surface names, and options out of range. Source: ours,
// docs/stages/surface_doubts.md.
SurfaceDoubts surface_doubts(const ReconstructResult& result, Points points,
                             const SurfaceDoubtOptions& options = {},
                             const Execution& execution = {});

}  // namespace cocoon
