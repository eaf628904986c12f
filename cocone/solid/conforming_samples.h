// Samples of a solid where its mesh wants more of them than their spacing gives: at walls and gaps
// that are thinner, and between edges that are closer.
#pragma once

#include <cstddef>
#include <vector>

#include "cocone/solid/solid_distances.h"
#include "geom/execution.h"
#include "geom/mesh/sharp_edges.h"
#include "geom/point.h"

namespace cocoon {

struct ConformingOptions {
  double spacing = 0;  // of the samples, in units of the coordinates; above 0
  // A cell crosses the mesh if it reaches farther than this part of its longest edge to both sides.
  double min_depth = 0.02;
  // No sample is added closer than so many spacings to another one.
  double closest = 0.0625;
  // One is moved to a sharp edge if that is no farther than this part of the distance to the
  // closest sample: so edges are cut into pieces that end on them.
  double snap = 0.7;
  double smooth_cosine = default_smooth_cosine;
  std::size_t max_rounds = 12;
};

struct ConformingSamples {
  std::vector<Point> added;
  std::size_t rounds = 0;        // in which samples were added
  std::size_t without_room = 0;  // times that a crossing cell gave no point for lack of room
};

// Points on the mesh to be added to `samples`, all of its vertices among them, until hardly a cell
// between them crosses it: then each is inside or outside (labels_of_solid.h), and what bounds
// those inside is the mesh. In each round every cell that crosses it gives a point on the mesh
// about where it does, if that is not too close to a sample; of points that are close to each other
// one is taken. Ends when there are none, or after max_rounds.
// Nothing is added if the mesh is not closed (balanced: mesh_check.h). Coordinates of any size.
// Throws InputError unless the spacing is a positive number and the other options are 0 or more,
// and for a triangle that names a vertex that is not there; DegenerateInput for samples in one
// plane; Cancelled. Complexity: O((t + n) log t) for the n cells of the samples and t triangles,
// less in later rounds, and a triangulation in each. Deterministic for any thread count. Source:
// ours. It is Delaunay refinement, as of Shewchuk 1998 (segments first, then facets) and Boissonnat
// & Oudot 2005 (points on the surface), with the sides of a cell as the test.
ConformingSamples conforming_samples(const SolidDistances& solid, Points samples,
                                     const ConformingOptions& options,
                                     const Execution& execution = {});

}  // namespace cocoon
