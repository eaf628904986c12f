#include "geom/search/winding_number.h"

#include <array>
#include <cstdint>

#include "geom/box.h"
#include "geom/orient3d.h"

namespace cocoon {
namespace {

// Of u, v and the shifted p, all seen along the x axis; zero iff u and v look the same.
Sign turn(const Point& u, const Point& v, const Point& p) {
  const Sign sign = orient2d(u.y, u.z, v.y, v.z, p.y, p.z);
  if (sign != Sign::zero) return sign;
  if (u.z != v.z) return u.z > v.z ? Sign::positive : Sign::negative;
  if (u.y != v.y) return u.y < v.y ? Sign::positive : Sign::negative;
  return Sign::zero;
}

// 1 where the ray from p leaves through the triangle, -1 where it enters, 0 where it passes by.
int crossing(const std::array<Point, 3>& t, const Point& p) {
  const Sign side = turn(t[0], t[1], p);
  if (side == Sign::zero || turn(t[1], t[2], p) != side || turn(t[2], t[0], p) != side) return 0;
  const Sign height = orient3d(t[0], t[1], t[2], p);
  if (height == Sign::zero || height == side) return 0;  // the triangle lies behind p
  return side == Sign::positive ? 1 : -1;
}

}  // namespace

WindingNumbers::WindingNumbers(const TriangleMesh& mesh, const Execution& execution)
    : tree_(triangle_tree(mesh, execution)) {}

int WindingNumbers::at(const Point& p) const {
  const Box box = tree_.boxes.box();
  if (!contains(box, p)) return 0;
  const Box ray{p, {box.high.x, p.y, p.z}};
  int number = 0;
  tree_.boxes.visit_overlapping(ray, [&](std::uint32_t slot) {
    // Most of those that share a leaf with one that the ray meets are beside it.
    const std::array<Point, 3>& corners = tree_.corners[slot];
    if (overlap(box_of(corners), ray)) number += crossing(corners, p);
  });
  return number;
}

}  // namespace cocoon
