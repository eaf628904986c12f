#include "geom/search/winding_number.h"

#include <algorithm>
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

// Whether the box of a triangle is beside the ray from p, or behind p: most are that share a leaf
// of the tree with one that is not, and this takes fewer operations than three turns.
bool is_off_ray(const std::array<Point, 3>& t, const Point& p) {
  const auto& [a, b, c] = t;
  return p.x > std::max(std::max(a.x, b.x), c.x) || p.y > std::max(std::max(a.y, b.y), c.y) ||
         p.z > std::max(std::max(a.z, b.z), c.z) || p.y < std::min(std::min(a.y, b.y), c.y) ||
         p.z < std::min(std::min(a.z, b.z), c.z);
}

// 1 where the ray from p leaves through the triangle, -1 where it enters, 0 where it passes by.
int crossing(const std::array<Point, 3>& t, const Point& p) {
  if (is_off_ray(t, p)) return 0;
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
  tree_.visit_overlapping(ray, [&](std::uint32_t slot) { number += crossing(corners_[slot], p); });
  return number;
}

}  // namespace cocoon
