// Sides of the surface that are known beforehand: where most points are those of an old mesh, it
// tells inside from outside around every vertex at which it is a surface of facets still.
#pragma once

#include <cstddef>
#include <span>

#include "cocone/mark_cells.h"
#include "delaunay/triangulation.h"
#include "geom/id_vector.h"
#include "geom/ids.h"

namespace cocoon {

struct KnownSides {
  IdVector<CellId, CellLabel> labels;  // unmarked: nothing is known
  std::size_t cells = 0;               // that have a label
  std::size_t contradictions = 0;      // cells told both: they stay unmarked
};

// A vertex is intact if all triangles at it are facets and leave no gap: as many run to each edge
// there as run from it. They divide the cells around it; those behind a triangle are labeled IN,
// those in front of one OUT, if all their vertices are corners of triangles (a cell with a new
// vertex may lie on either side). Infinite cells are not labeled (they are OUT anyway). If the
// triangles bound a union of cells, no cell is told both.
// Complexity: O(cells + t) for t triangles, for bounded valence. Deterministic: independent of
// their order. Source: ours, docs/stages/mark_cells.md.
KnownSides known_sides(const Triangulation& triangulation,
                       std::span<const KnownTriangle> triangles);

}  // namespace cocoon
