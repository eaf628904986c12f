// The angles between facets and the circumballs of the cells on their two sides.
//
// Some cells have no height: their four samples lie in one plane but for the rounding of their
// coordinates, as on the faces of machine parts that do not lie along the axes. If they lie on a
// circle, too, as around a hole, the center of their ball is anywhere on its axis: a pile of such
// cells leads from the outside into the body by balls each of which meets the next deeply. So balls
// of flat cells are not asked: one looks through them, at the cell beyond.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "delaunay/triangulation.h"
#include "geom/arrays/zeroed_array.h"
#include "geom/execution.h"

namespace cocoon {

// Computed when asked for, or ahead (but for flat cells), for the four facets of a cell at once,
// and remembered: 33 bytes for each cell that was asked about, 16 more for each flat one. Every
// question may write: not to be shared by threads.
class BallCosines {
 public:
  // Keeps the reference, which must outlive the object. O(1). A cell is flat if its height over its
  // largest facet is at most `flat_ratio` times the size of that facet, the root of twice its area.
  BallCosines(const Triangulation& triangulation, double flat_ratio);

  // Computes ahead what will be asked of these cells; returns the centers of the finite ones, which
  // take part in that. Complexity: O(cells given), parallel.
  ZeroedArray<CellId, Point> prepare(std::span<const CellId> cells, const Execution& execution);

  // For facet f seen from its cell: the cosine of the angle between the facet and the tangent plane
  // of the cell's ball at the facet's circle; 1 if the ball is a half-space beyond the facet (as
  // for an infinite cell), -1 if it is one on the other side; 0 where it cannot be computed. Of a
  // flat cell: with the ball that is seen through it. A function of the corners and the center, not
  // of their order. O(1).
  double of(FacetId f) {
    const CellId c = cell_of(f);
    if (triangulation_.is_infinite(c)) return 1;
    if (known(c) == Known::flat) look_through(c);
    return cosines_[c][static_cast<std::size_t>(index_of(f))];
  }

  // The cosine of the angle at which the balls of the two cells of a facet meet: 1 for equal balls,
  // 0 if their surfaces cross at right angles, -1 if they touch. The same from both sides. O(1).
  double contact(FacetId f);

  // Infinite cells are not.
  bool is_flat(CellId c) {
    return flat_ratio_ > 0 && !triangulation_.is_infinite(c) && known(c) >= Known::flat;
  }
  // Asks memory for what is known of a cell. O(1).
  void ask_ahead(CellId c) const {
    __builtin_prefetch(&known_[c]);
    __builtin_prefetch(&cosines_[c]);
  }

  // The cell behind facet f, through flat ones, each of which is left by the largest facet that
  // faces the other way than the one by which it was entered; none if that leads back to where it
  // has been. O(1) but for those; each is passed once, however many questions lead through it: a
  // plane whose coordinates differ by rounding alone may have a thousand one over the other.
  CellId beyond(FacetId f) {
    const FacetId behind = triangulation_.mirror(f);
    return is_flat(cell_of(behind)) ? through(behind) : cell_of(behind);
  }
  // Both sides of a flat cell: the cells beyond its largest facet, from within and from outside;
  // none as beyond() says.
  std::array<CellId, 2> sides_of_flat(CellId c);

 private:
  // seen_through: a flat cell whose cosines are those of the balls seen through it.
  enum class Known : std::uint8_t { nothing = 0, cosines, flat, seen_through };
  Known known(CellId c) {
    const Known now = known_[c];
    return now != Known::nothing ? now : ask(c);
  }
  Known ask(CellId c);
  template <class Visit>
  void compute(std::span<const CellId> cells, Visit visit);
  void look_through(CellId c);
  double cosine_through(FacetId f);
  CellId through(FacetId f);
  // What is known of where a facet of a flat cell leads; other values are first_end + a cell.
  static constexpr std::uint32_t not_asked = 0;
  static constexpr std::uint32_t nowhere = 1;
  static constexpr std::uint32_t first_end = 2;
  std::pair<double, Point> size_in_cell(FacetId f) const;
  int far_side(FacetId f) const;

  const Triangulation& triangulation_;
  double flat_ratio_;
  ZeroedArray<CellId, std::array<double, 4>> cosines_;
  ZeroedArray<CellId, Known> known_;
  ZeroedArray<CellId, std::array<std::uint32_t, 4>> ends_;
  std::vector<FacetId> passed_;  // of one walk
};

}  // namespace cocoon
