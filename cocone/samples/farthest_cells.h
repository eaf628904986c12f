// The farthest Voronoi vertex of every sample, by its cell: maxima that each thread raises for
// itself (geom/parallel/parallel_fold.h). One word each, the length rounded to float in the upper
// half, so that most questions end there; what rounds alike is compared in double precision.
#pragma once

#include <array>
#include <cstdint>
#include <limits>

#include "cocone/samples/cell_arms.h"
#include "cocone/samples/double_cone.h"
#include "delaunay/triangulation.h"
#include "delaunay/voronoi/cell_blocks.h"
#include "delaunay/voronoi_dual.h"
#include "geom/execution.h"
#include "geom/id_vector.h"
#include "geom/point.h"

namespace cocoon {

// A Voronoi vertex relative to a sample. Slivers have centers so far that squares overflow; then
// two of them are compared in larger units.
struct Arm {
  Vec3 vector;
  double squared_length;

  explicit Arm(const Vec3& v) : vector(v), squared_length(squared_norm(v)) {}
  bool is_far() const { return !(squared_length <= std::numeric_limits<double>::max()); }
  Vec3 safe() const { return is_far() ? shrink * vector : vector; }

  // Longer, or as long and lexicographically smaller.
  bool precedes(const Arm& other) const;
};

// From the sample p to the Voronoi vertex of the cell c. O(1).
Arm arm_of(const Triangulation& triangulation, const Dual& dual, CellId c, VertexId p);

class FarthestCells {
 public:
  // No cells yet. Both must outlive this. O(vertices).
  FarthestCells(const Triangulation& triangulation, const Dual& dual);

  // The cells first, first + 1, ... of a block, with its words. Complexity: O(cells).
  void offer(CellId first, const CellBlock& block, const ArmWords& words);
  // All that were offered to others, of the same triangulation. Complexity: O(vertices), parallel.
  void join(const FarthestCells& others, const Execution& execution);

  // The farthest of those offered; the one that precedes among those as far.
  CellId farthest(VertexId p) const;

  // What offer() looks at, one word for each vertex.
  const void* words() const { return words_.raw().data(); }

 private:
  using Words = std::array<std::uint64_t, 4>;  // one for each corner of a cell

  void decide_ties(CellId c, const Point& center, const Words& known, const Words& offered);
  bool precedes(VertexId p, const Point& center, std::uint64_t known) const;

  const Triangulation& triangulation_;
  const Dual& dual_;
  IdVector<VertexId, std::uint64_t> words_;
};

}  // namespace cocoon
