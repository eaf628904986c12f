#include "geom/search/grid_cells.h"

#include <vector>

namespace cocoon {
namespace {

// Rounding and cutting off keep the order: what lies between two coordinates comes to lie in a cell
// between theirs.
std::uint32_t coordinate(double x, double origin, double cells_per_length, int bits) {
  const std::uint32_t last = (std::uint32_t{1} << bits) - 1;
  const double along = (x - origin) * cells_per_length;
  if (!(along > 0)) return 0;
  return along < last ? static_cast<std::uint32_t>(along) : last;
}

double cells_per(double length, int bits) {
  return length > 0 ? static_cast<double>(std::uint32_t{1} << bits) / length : 0;
}

}  // namespace

GridCells::GridCells(const IdVector<VertexId, Point>& points) {
  const Box box = box_of(points.span());
  origin_ = box.low;
  const Vec3 size = box.size();
  cells_per_length_ = {cells_per(size.x, bits_x), cells_per(size.y, bits_y),
                       cells_per(size.z, bits_z)};
  cells_.reserve(points.size());
  for (const Point& p : points) cells_.push_back(cell_of(p));
}

void GridCells::edit(const ListEdit<VertexId>& edit, Points added) {
  std::vector<std::uint32_t> cells;
  cells.reserve(added.size());
  for (const Point& p : added) cells.push_back(cell_of(p));
  edit_list(cells_, edit, cells);
}

std::uint32_t GridCells::cell_of(const Point& p) const {
  return coordinate(p.x, origin_.x, cells_per_length_.x, bits_x) |
         coordinate(p.y, origin_.y, cells_per_length_.y, bits_y) << shift_y |
         coordinate(p.z, origin_.z, cells_per_length_.z, bits_z) << shift_z;
}

}  // namespace cocoon
