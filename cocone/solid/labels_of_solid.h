// The labels of cells between samples of a solid whose surface is at hand as a mesh.
#pragma once

#include <span>

#include "cocone/known_labels.h"
#include "cocone/solid/cell_heights.h"
#include "cocone/solid/solid_distances.h"
#include "delaunay/triangulation.h"
#include "geom/execution.h"
#include "geom/ids.h"
#include "geom/point.h"
#include "geom/triangle_mesh.h"

namespace cocoon {

struct LabelsOfSolidOptions {
  CellPlaces places = CellPlaces::centroid_and_edges;
  // A cell is told if it reaches farther from the mesh than this part of its longest edge
  // (cell_heights.h): others are slivers on the surface, which may as well lie on either side of
  // it.
  double min_depth = 0.03;
};

// For cells that may cross the mesh, as those of its vertices alone: most of such a cell is where
// its centroid is.
inline constexpr LabelsOfSolidOptions labels_of_crossing_cells = {CellPlaces::centroid, 0.05};

// Finite cells that reach farther into the mesh than out of it are labeled IN, others OUT. Right
// where cells do not cross the surface, as those of conforming samples do not
// (conforming_samples.h).
// `solid` is in the coordinates of the triangulation's vertices. Nothing is known if it is not
// closed (balanced: mesh_check.h).
// Throws InputError as signed_distances() and for a depth that is negative or no number; Cancelled.
// Complexity: O((t + n) log t) for t triangles and n cells. Deterministic for any thread count.
// Source: ours, docs/stages/labels_of_solid.md.
KnownLabels labels_of_solid(const Triangulation& triangulation, const SolidDistances& solid,
                            const LabelsOfSolidOptions& options = {},
                            const Execution& execution = {});

// The same for `cells` only, beside what is known of others. What is known of these cells already
// is kept, but forgotten where the solid tells otherwise. With CellPlaces::centroid no distance is
// asked of those whose centroid lies on the side that is known.
void add_labels_of_solid(const Triangulation& triangulation, const SolidDistances& solid,
                         std::span<const CellId> cells, KnownLabels& known,
                         const LabelsOfSolidOptions& options = {}, const Execution& execution = {});

// Asks labels_of_solid for `solid`, in the coordinates of its samples, in their triangulation: that
// of working_scale(samples) times them (reconstruct.h). Keeps the mesh. Complexity: O(n + t).
KnownLabelsSource labels_told_by(TriangleMesh solid, Points samples,
                                 const LabelsOfSolidOptions& options = {});

// Overload for who asks the same solid elsewhere: keeps `solid`, and remembers with it.
KnownLabelsSource labels_told_by(SolidDistances solid, Points samples,
                                 const LabelsOfSolidOptions& options = {});

}  // namespace cocoon
