// Where Voronoi vertices lie to the double cones about the normals of their samples.
#pragma once

#include <cstddef>
#include <cstdint>

#include "cocone/cell_arms.h"
#include "delaunay/triangulation.h"
#include "delaunay/voronoi_dual.h"
#include "geom/execution.h"
#include "geom/id_vector.h"
#include "geom/point.h"

namespace cocoon {

// Of the Voronoi vertex of a cell, or of the direction of its ray: bit j = in the lower nappe of
// the double cone of corner j, bit 4 + j = in the upper one (double_cone.h).
using CornerSides = std::uint8_t;

struct ConeSides {
  double cosine = 0;  // of the angle between the cones and their axes
  IdVector<CellId, CornerSides> of_cells;
};

// Of all cells. Complexity: O(cells), parallel.
ConeSides cone_sides(const Triangulation& triangulation, const Dual& dual,
                     const IdVector<VertexId, Vec3>& normals, double cosine,
                     const Execution& execution = {});

// Of one cell, of any size. O(1).
CornerSides cone_sides_of_cell(const Triangulation& triangulation, const Dual& dual,
                               const IdVector<VertexId, Vec3>& normals, double squared_cosine,
                               CellId c);

// Of cells whose arms are known: first, first + 1, ... (`arms` as of arm_sides() with the same
// cosine).
inline void take_cone_sides(const Triangulation& triangulation, const Dual& dual,
                            const IdVector<VertexId, Vec3>& normals, const ArmSides& arms,
                            CellId first, std::size_t count, ConeSides& sides) {
  for (std::size_t k = 0; k < count; ++k) {
    const CellId c(first.index() + k);
    sides.of_cells[c] = arms.unsafe[k] == 0 ? arms.nappes[k]
                                            : cone_sides_of_cell(triangulation, dual, normals,
                                                                 sides.cosine * sides.cosine, c);
  }
}

}  // namespace cocoon
