// How a triangulation starts: points that span space, and the five cells of a tetrahedron.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "delaunay/kernel/cell_pool.h"
#include "geom/id_vector.h"
#include "geom/point.h"

namespace cocoon {

// Moves vertices that span as much as possible to the front of `order`, the others keep their
// order. Precondition: the points of `order` are all different. Returns their affine dimension:
// 3 if order[0..3] span space, 2 if all lie in one plane, 1 on one line, 0 for one point or none.
// Complexity: O(n) at worst, O(1) if the first points are in general position.
int bring_simplex_to_front(const IdVector<VertexId, Point>& points,
                           std::vector<std::uint32_t>& order);

// Fills an empty pool with one finite cell and the four infinite ones around it. Precondition: the
// corners span space.
void make_first_cells(CellPool& pool, const IdVector<VertexId, Point>& points,
                      std::array<VertexId, 4> corners);

}  // namespace cocoon
