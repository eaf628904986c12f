// In which cell of a coarse grid each point of a list lies: who asks for the few points in a box
// reads four bytes of each other one, not its coordinates.
#pragma once

#include <cstdint>
#include <span>

#include "geom/arrays/list_edit.h"
#include "geom/arrays/visit_where.h"
#include "geom/box.h"
#include "geom/id_vector.h"
#include "geom/ids.h"
#include "geom/point.h"

namespace cocoon {

class GridCells {
 public:
  GridCells() = default;
  // The grid divides the bounding box of the points, which are finite. Complexity: O(n).
  explicit GridCells(const IdVector<VertexId, Point>& points);

  std::size_t size() const { return cells_.size(); }
  // Follows an edit of the list, whose new elements are `added`. Points off the grid count as in
  // its outermost cells. Complexity: O(n), a pass in place over the cells.
  void edit(const ListEdit<VertexId>& edit, Points added);

  // Calls visit(v) for all points in the box, ascending. `points`: the list. Complexity: O(n), a
  // few operations on integers for each point.
  template <class Visit>
  void visit_in(const Box& box, const IdVector<VertexId, Point>& points, const Visit& visit) const {
    if (box.is_empty()) return;
    const std::uint32_t low = cell_of(box.low);
    const std::uint32_t high = cell_of(box.high) | guards;
    // A difference borrows from its guard bit iff it is negative. All three coordinates at once.
    const std::span<const std::uint32_t> cells = cells_.span();
    const auto may_be_inside = [&](std::size_t i) {
      return (((cells[i] | guards) - low) & (high - cells[i]) & guards) == guards;
    };
    visit_where(cells_.size(), may_be_inside, [&](std::size_t i) {
      const VertexId v(i);
      if (contains(box, points[v])) visit(v);
    });
  }

 private:
  // Three coordinates of 10, 10 and 9 bits, with a bit above each that is 0.
  static constexpr int bits_x = 10, bits_y = 10, bits_z = 9;
  static constexpr int shift_y = bits_x + 1, shift_z = shift_y + bits_y + 1;
  static constexpr std::uint32_t guards = std::uint32_t{1} << bits_x |
                                          std::uint32_t{1} << (shift_y + bits_y) |
                                          std::uint32_t{1} << (shift_z + bits_z);

  std::uint32_t cell_of(const Point& p) const;

  Point origin_;
  Vec3 cells_per_length_;
  IdVector<VertexId, std::uint32_t> cells_;
};

}  // namespace cocoon
