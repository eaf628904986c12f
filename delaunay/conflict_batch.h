// The in-sphere test of the kernel: several finite cells against one point, in SIMD lanes.
#pragma once

#include <cstddef>

#include "delaunay/cell_pool.h"
#include "geom/id_vector.h"
#include "geom/point.h"

namespace cocoon {

inline constexpr std::size_t conflict_batch_size = 4;

// Bit i speaks of the i-th cell of the batch.
struct BatchDecision {
  unsigned inside = 0;     // certainly: the circumsphere contains the point
  unsigned on_sphere = 0;  // certainly: the point lies on the circumsphere
  unsigned undecided = 0;  // the filter cannot tell; the exact predicate must
  unsigned infinite = 0;   // not a finite cell
};

// What the tests of one triangulation have in common.
class ConflictFilter {
 public:
  // `points` must outlive the filter and end with one element that is no vertex: the last vertex is
  // read as four doubles. Complexity: O(n).
  explicit ConflictFilter(const IdVector<VertexId, Point>& points);

  // To be called when `points` was filled with other points. Complexity: O(n).
  void read_points_again();

  // To be called for a vertex that was not in `points` at construction, before it is tested or
  // becomes a corner of a cell. Complexity: O(1).
  void admit(const Point& p);

  // First level of insphere (geom/insphere.h: same expression, same bound, same bits on every
  // instruction set) for the conflict_batch_size cells with the given ids; the value is also known
  // to be exact where it is small in units of a grid on which all points lie. The instruction set
  // is chosen at run time. Answers for infinite cells mean nothing. Complexity: O(1), about the
  // time of one scalar test.
  BatchDecision test(const IdVector<CellId, Cell>& cells, const CellId* ids, const Point& p) const;

 private:
  const IdVector<VertexId, Point>& points_;
  double unit_;           // all coordinates are multiples of it; 0: nothing is known
  double exact_product_;  // the value is exact while X Y Z L (see insphere.h) is at most this
};

}  // namespace cocoon
