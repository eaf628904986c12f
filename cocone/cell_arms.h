// The arms of cells: from the corners to the circumcenter, four at once in SIMD lanes.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "delaunay/triangulation.h"
#include "delaunay/voronoi_dual.h"
#include "geom/id_vector.h"
#include "geom/point.h"

namespace cocoon {

inline constexpr std::size_t max_arm_cells = 128;

// The arms of some successive cells; arm 4 k + j: of corner j of cell k.
struct SquaredArms {
  alignas(32) std::array<double, 4 * max_arm_cells> lengths;
};

// And how they lie to the normals of their corners. One bit per corner.
struct ArmSides {
  SquaredArms squared;
  std::array<std::uint8_t, max_arm_cells> negative;  // arm . normal < 0
  // In the lower nappe of the double cone (double_cone.h), and 16 times in the upper one.
  std::array<std::uint8_t, max_arm_cells> nappes;
  // Not between the safe lengths of double_cone.h: nothing above is to be trusted.
  std::array<std::uint8_t, max_arm_cells> unsafe;
};

// squared_norm(center - point) of the cells first ... first + count - 1, bit for bit.
// Preconditions: finite cells; count <= max_arm_cells. Complexity: O(count).
void squared_arms(const Triangulation& triangulation, const Dual& dual, CellId first,
                  std::size_t count, SquaredArms& arms);

// And the sides, as dot() and cone_side() tell them. Preconditions as above.
void arm_sides(const Triangulation& triangulation, const Dual& dual,
               const IdVector<VertexId, Vec3>& normals, double squared_cosine, CellId first,
               std::size_t count, ArmSides& arms);

}  // namespace cocoon
