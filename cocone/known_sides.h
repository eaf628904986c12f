// Sides of the surface that are known beforehand: where most points are those of an old mesh, its
// triangles tell inside from outside wherever they are triangles of the Cocone surface again.
#pragma once

#include <cstddef>
#include <span>

#include "cocone/linked_facets.h"
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

// Labels the cell in front of each triangle OUT and the one behind it IN, if all its vertices are
// corners of such triangles (a cell with a new vertex may lie on either side), and if the triangle
// is one of the Cocone surface, too: where the old mesh closed what the samples left open, it knows
// no more than they do. Infinite cells are not labeled (they are OUT anyway).
// Complexity: O(cells + t) for t triangles of either surface, for bounded valence. Deterministic:
// independent of their order. Source: ours, docs/stages/mark_cells.md.
KnownSides known_sides(const Triangulation& triangulation, const LinkedFacets& surface,
                       std::span<const KnownTriangle> triangles);

}  // namespace cocoon
