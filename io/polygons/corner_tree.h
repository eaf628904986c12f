// The corners of a polygon in the plane, to be found where a triangle is.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "geom/orient3d.h"
#include "geom/sign.h"

namespace cocoon {

struct Planar {
  double x = 0;
  double y = 0;

  friend bool operator==(const Planar&, const Planar&) = default;
};

// The side of c on the line from a to b: positive to the left. Exact.
inline Sign turn(const Planar& a, const Planar& b, const Planar& c) {
  return orient2d(a.x, a.y, b.x, b.y, c.x, c.y);
}

// A tree of boxes over points, from which points are taken away.
class CornerTree {
 public:
  // Precondition: fewer than 2^31 points, which stay where they are while the tree is used.
  // Complexity: O(n log n).
  explicit CornerTree(std::span<const Planar> points);

  // Precondition: the point is there. Complexity: O(log n).
  void take_away(std::size_t point);

  // Calls visit(point) -> bool for all that are there in the closed triangle a, b, c, which turns
  // left, and for some near it, until a call returns false. In no certain order, but always the
  // same. Complexity: O(log n) and a call for each, for points that lie on a few curves.
  template <class Visit>
  void visit_near(const std::array<Planar, 3>& triangle, const Visit& visit) const;

 private:
  struct Node {
    Planar low;
    Planar high;
    std::uint32_t left = 0;  // points that are there
  };
  // The points [begin, end) of order_ and their node; the children of node k are 2 k + 1, 2 k + 2.
  struct Range {
    std::size_t begin;
    std::size_t end;
    std::size_t node;

    bool is_leaf() const { return end - begin <= 8; }
    Range first() const { return {begin, (begin + end) / 2, 2 * node + 1}; }
    Range second() const { return {(begin + end) / 2, end, 2 * node + 2}; }
  };
  Range whole() const { return {0, order_.size(), 0}; }
  void build(const Range& range);
  static bool is_beside(const Node& node, const std::array<Planar, 3>& triangle);

  std::span<const Planar> points_;
  std::vector<std::uint32_t> order_;  // of the points in the tree
  std::vector<std::uint32_t> place_;  // of each point in order_
  std::vector<char> is_away_;
  std::vector<Node> nodes_;
};

template <class Visit>
void CornerTree::visit_near(const std::array<Planar, 3>& triangle, const Visit& visit) const {
  std::array<Range, 40> stack;
  std::size_t size = 0;
  stack[size++] = whole();
  while (size > 0) {
    const Range range = stack[--size];
    const Node& node = nodes_[range.node];
    if (node.left == 0 || is_beside(node, triangle)) continue;
    if (!range.is_leaf()) {
      stack[size++] = range.second();
      stack[size++] = range.first();
      continue;
    }
    for (std::size_t k = range.begin; k < range.end; ++k) {
      if (is_away_[order_[k]] == 0 && !visit(std::size_t{order_[k]})) return;
    }
  }
}

}  // namespace cocoon
