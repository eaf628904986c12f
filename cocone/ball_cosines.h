// The angles between facets and the circumballs of the cells on their two sides.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "delaunay/triangulation.h"
#include "geom/execution.h"
#include "geom/zeroed_array.h"

namespace cocoon {

// Computed when asked for, or ahead, for the four facets of a cell at once, and remembered: 33
// bytes for each cell that was asked about. Not to be shared by threads.
class BallCosines {
 public:
  // Keeps the reference, which must outlive the object. O(1).
  explicit BallCosines(const Triangulation& triangulation);

  // Computes ahead what will be asked of these cells. Complexity: O(cells given), parallel.
  void prepare(std::span<const CellId> cells, const Execution& execution);

  // For facet f seen from its cell: the cosine of the angle between the facet and the tangent plane
  // of the cell's ball at the facet's circle; 1 if the ball is a half-space beyond the facet (as
  // for an infinite cell), -1 if it is one on the other side; 0 where it cannot be computed.
  // A function of the corners and the center, not of their order. O(1).
  double of(FacetId f);

  // The cosine of the angle at which the balls of the two cells of a facet meet: 1 for equal balls,
  // 0 if their surfaces cross at right angles, -1 if they touch. The same from both sides. O(1).
  double contact(FacetId f);

 private:
  std::array<double, 4> compute(CellId c, const Point& center) const;

  const Triangulation& triangulation_;
  ZeroedArray<CellId, std::array<double, 4>> cosines_;
  ZeroedArray<CellId, std::uint8_t> known_;
};

}  // namespace cocoon
