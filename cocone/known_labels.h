// Labels of cells that are known beforehand, which marking and clean-up heed where the samples
// leave doubt. Where most points are those of an old mesh, it tells inside from outside around
// every vertex at which it is a surface of facets still.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "cocone/facet_set.h"
#include "cocone/marking/cell_label.h"
#include "delaunay/triangulation.h"
#include "geom/execution.h"
#include "geom/id_vector.h"
#include "geom/ids.h"

namespace cocoon {

struct KnownLabels {
  // Unmarked: nothing is known of that cell. Empty: of none.
  IdVector<CellId, CellLabel> labels;
  std::size_t cells = 0;           // that have a label
  std::size_t contradictions = 0;  // cells told both: they stay unmarked
  // Cells at triangles that are no facets, though all that was around their corners is kept. Such a
  // triangle may cut through the cell: `labels` has for it what triangles at other corners tell, if
  // any do, but most of it may lie on the other side. There are none in a mesh whose triangles were
  // facets of a triangulation of its vertices; in others there are where sheets are closer than
  // vertices, or a grid has other diagonals. So if there are any the mesh is foreign, and what it
  // tells need not fit the samples. Then `labels` has all cells.
  std::vector<CellId> undisturbed;
  bool is_foreign() const { return !undisturbed.empty(); }
  // What is likely of cells of which `labels` tells nothing, as of those on lines of sight.
  // Unmarked: nothing is. Empty: of none. Heeded where the surface is no rougher by it
  // (checks/surface_roughness.h).
  IdVector<CellId, CellLabel> likely;
};

// What tells the labels of a triangulation's cells; asked only where something is in doubt, or (for
// what is likely alone) marks do not reach all good vertices.
// `surface` is what the stages hold for the surface: it may tell where to look, not what is true.
// An empty source knows nothing.
using KnownLabelsSource = std::function<KnownLabels(
    const Triangulation& triangulation, const FacetSet& surface, const Execution& execution)>;

// Of an old mesh, on the surface still: corners as positions among the input points,
// counterclockwise seen from outside.
using KnownTriangle = std::array<PointId, 3>;

// Triangles for those who know where a mesh has changed (kept_labels.h).
struct KnownTriangles {
  // The input points at which a triangle of the old mesh is not known; each may come several times.
  std::function<std::vector<PointId>()> torn;
  // All known triangles at these points (ascending), each once.
  std::function<std::vector<KnownTriangle>(std::span<const PointId> points)> at;
};

// Adds what is likely, beside what is known.
using AddLikely = std::function<void(const Triangulation& triangulation, KnownLabels& known,
                                     const Execution& execution)>;

// An old surface, and what is known of it.
struct OldSurface {
  KnownLabelsSource labels;
  // The triangles that `labels` tells from, if it does: wanted where the body that the surface
  // bounds is kept from one update to the next.
  KnownTriangles triangles = {};
  // What `labels` has of likely ones, for the same; none: nothing.
  AddLikely add_likely = {};
};

// Of a vertex:
//   intact       There are triangles at it, all are facets, and they leave no gap: as many run to
//                each edge there as run from it.
//   undisturbed  Its triangles leave no gap and all its neighbors are corners of triangles, though
//                not all triangles at it are facets. (In a mesh of facets none is: what takes a
//                triangle away is a new neighbor of each of its corners.)
// The triangles of an intact vertex divide the cells around it: those behind one are labeled IN,
// those in front of one OUT. A cell with new vertices may lie on either side: it is labeled only if
// every corner of a triangle that it has is intact, for where a vertex keeps all its triangles the
// surface has not changed. Infinite cells are not labeled (they are OUT anyway). If the triangles
// bound a union of cells, no cell is told both. Without triangles nothing is known.
// A cell is undisturbed if one of its vertices is, and the triangles at the others leave no gap.
// Triangles are looked for in `surface` first, which changes nothing else. Errors: InputError for
// one of another triangulation, by its size. Complexity: O(cells + t) for t triangles, for bounded
// valence; in part parallel. Deterministic: independent of their order and of the threads. Source:
// ours, docs/stages/known_labels.md.
KnownLabels known_labels(const Triangulation& triangulation,
                         std::span<const KnownTriangle> triangles, const FacetSet& surface,
                         const Execution& execution = {});

}  // namespace cocoon
