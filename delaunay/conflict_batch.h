// The in-sphere test of the kernel: several finite cells against one point, in SIMD lanes.
#pragma once

#include <cstddef>
#include <span>

#include "delaunay/cell_pool.h"
#include "geom/id_vector.h"
#include "geom/point.h"

namespace cocoon {

inline constexpr std::size_t conflict_batch_size = 4;

// Bit i speaks of the i-th cell of the batch.
struct BatchDecision {
  unsigned inside = 0;     // certainly: the circumsphere contains the point
  unsigned undecided = 0;  // the filter cannot tell; the exact predicate must
};

// First level of insphere (geom/insphere.h: same expression, same bound, same bits on every
// instruction set) for conflict_batch_size finite cells at once. The instruction set is chosen at
// run time. Reads 8 bytes past the coordinates of a vertex: the last element of `points` must
// not be a vertex of the cells. Complexity: O(1), about the time of one scalar test.
BatchDecision insphere_batch(std::span<const Cell* const, conflict_batch_size> cells,
                             const IdVector<VertexId, Point>& points, const Point& p);

}  // namespace cocoon
