#include "geom/search/winding_number.h"

#include <array>
#include <cstdint>

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

WindingNumbers::WindingNumbers(const TriangleMesh& mesh, const Execution& execution) {
  std::vector<Box> boxes;
  boxes.reserve(mesh.triangles.size());
  for (const TriangleId t : mesh.triangles.ids()) {
    boxes.push_back(box_of(finite_corners_of(mesh, t)));
    box_.include(boxes.back());
  }
  tree_ = BoxTree(boxes, execution);
  corners_.reserve(boxes.size());
  for (const std::uint32_t t : tree_.items()) corners_.push_back(corners_of(mesh, TriangleId(t)));
}

int WindingNumbers::at(const Point& p) const {
  if (!contains(box_, p)) return 0;
  const Box ray{p, {box_.high.x, p.y, p.z}};
  int number = 0;
  tree_.visit_overlapping(ray, [&](std::uint32_t slot) {
    // Most of those that share a leaf with one that the ray meets are beside it.
    if (overlap(box_of(corners_[slot]), ray)) number += crossing(corners_[slot], p);
  });
  return number;
}

}  // namespace cocoon
