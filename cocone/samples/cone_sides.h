// Where Voronoi vertices lie to the double cones about the normals of their samples.
#pragma once

#include <cstddef>
#include <cstdint>

#include "cocone/samples/cell_arms.h"
#include "delaunay/triangulation.h"
#include "delaunay/voronoi_dual.h"
#include "geom/execution.h"
#include "geom/id_vector.h"
#include "geom/point.h"

namespace cocoon {

// Where the Voronoi vertex of a cell, or the direction of its ray, lies to the double cones of the
// corners (double_cone.h). The corners are taken in the order of their ids, so that two cells have
// what they see of the corners they share in the same order.
struct CornerSides {
  // Bit r = in the lower nappe of the corner with the r-th smallest id, bit 4 + r = in the upper
  // one.
  std::uint8_t nappes = 0;
  std::uint8_t ranks = 0;  // bits 2 j and 2 j + 1: the r of vertex j of the cell

  friend bool operator==(const CornerSides&, const CornerSides&) = default;
};

// The r of each vertex of a cell, as in CornerSides. Vertex 3 of an infinite cell is the last.
inline std::uint8_t vertex_ranks(const Cell& cell) {
  const auto& [a, b, c, d] = cell.vertices;
  // Each pair in the other order moves one rank up and one down.
  const int swapped = (a > b ? 3 : 0) + (a > c ? 15 : 0) + (a > d ? 63 : 0) + (b > c ? 12 : 0) +
                      (b > d ? 60 : 0) + (c > d ? 48 : 0);
  return static_cast<std::uint8_t>(0b11'10'01'00 - swapped);
}

struct ConeSides {
  double cosine = 0;  // of the angle between the cones and their axes
  IdVector<CellId, CornerSides> of_cells;
};

// Of all cells. Complexity: O(cells), parallel.
ConeSides cone_sides(const Triangulation& triangulation, const Dual& dual,
                     const IdVector<VertexId, Vec3>& normals, double cosine,
                     const Execution& execution = {});

// Of cells whose arms are known: first, first + 1, ... (`arms` as of arm_sides() with the same
// cosine). Complexity: O(count).
void take_cone_sides(const Triangulation& triangulation, const Dual& dual,
                     const IdVector<VertexId, Vec3>& normals, const ArmSides& arms, CellId first,
                     std::size_t count, ConeSides& sides);

// Of all infinite cells. Complexity: O(infinite cells), parallel.
void take_ray_sides(const Triangulation& triangulation, const Dual& dual,
                    const IdVector<VertexId, Vec3>& normals, ConeSides& sides,
                    const Execution& execution);

}  // namespace cocoon
