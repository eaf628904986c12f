// A bounding volume hierarchy: finds the boxes near a point, on a ray or overlapping another box.
// What the boxes stand for (triangles, points) is the caller's; see closest_facet, nearest_point
// and self_intersection.
#pragma once

#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "geom/box.h"
#include "geom/execution.h"

namespace cocoon {

// Invariant: every node's box holds the boxes of its items; the tree is balanced (median splits),
// so that its depth is at most 33. Flat arrays, no pointers; safe to query from many threads.
class BoxTree {
 public:
  BoxTree() = default;
  // Complexity: O(n log n), parallel. Items are named by their position in `boxes`, fewer than
  // 2^32. The same tree for every thread count.
  explicit BoxTree(std::span<const Box> boxes, const Execution& execution = {});

  // Items in the order of the leaves: queries name a slot of it, since data stored in this order
  // is read consecutively.
  const std::vector<std::uint32_t>& items() const { return items_; }

  // Around all boxes; empty for no items. Complexity: O(1).
  Box box() const { return nodes_.empty() ? Box() : nodes_[0].box; }

  // Calls visit(slot) -> double for all items, nearer nodes first, but for those in nodes whose
  // box is farther from p than `bound` (squared). Each call returns the new bound.
  template <class Visit>
  void visit_near(const Point& p, double bound, const Visit& visit) const;

  // Calls visit(slot) for the items in all leaves whose box overlaps `box`. The items' own boxes
  // need not overlap it.
  template <class Visit>
  void visit_overlapping(const Box& box, const Visit& visit) const;

  // Calls visit(slot) -> bool for the items in all leaves whose box the ray from p along `way`
  // meets (ray_meets), until it returns true for one; whether it did. The items' own boxes need not
  // be met.
  template <class Visit>
  bool any_on_ray(const Point& p, const Vec3& way, const Visit& visit) const;

 private:
  // A leaf holds the slots [first, first + count). An inner node has count = 0, its children are
  // the node after it and node `first`.
  struct Node {
    Box box;
    std::uint32_t first = 0;
    std::uint32_t count = 0;
  };
  static constexpr std::size_t max_depth = 40;
  static constexpr std::size_t leaf_size = 4;

  // Calls visit(slot) for the items in all leaves in whose box, and in those of whose ancestors,
  // meets(box) holds, until it returns true; whether it did.
  template <class Meets, class Visit>
  bool any_in_boxes(const Meets& meets, const Visit& visit) const;

  struct Center {
    Point at;
    std::uint32_t item = 0;
  };
  // A subtree: its items, the first of the slots that they fill, and its root.
  struct Subtree {
    std::span<Center> centers;
    std::size_t first;
    std::uint32_t root;
  };
  std::uint32_t build(std::span<const Box> boxes, const Subtree& subtree);
  void make_leaf(std::span<const Box> boxes, const Subtree& leaf);
  void join_boxes(std::uint32_t inner);

  std::vector<Node> nodes_;  // the root first; empty for no items
  std::vector<std::uint32_t> items_;
};

// The tree of points, each a box without extent. Complexity: O(n log n).
BoxTree tree_of_points(std::span<const Point> points);

// How many of the points that `tree` is of are no farther from p than the square root of
// `squared_reach`; once there are more than `most`, `most` + 1. Complexity: as visit_near.
std::size_t count_near(const BoxTree& tree, std::span<const Point> points, const Point& p,
                       double squared_reach, std::size_t most);

template <class Visit>
void BoxTree::visit_near(const Point& p, double bound, const Visit& visit) const {
  if (nodes_.empty()) return;
  struct Entry {
    std::uint32_t node;
    double squared_distance;
  };
  std::array<Entry, max_depth> stack;
  std::size_t size = 0;
  stack[size++] = {0, squared_distance(p, nodes_[0].box)};
  while (size > 0) {
    const Entry entry = stack[--size];
    if (entry.squared_distance > bound) continue;
    const Node& node = nodes_[entry.node];
    for (std::uint32_t k = 0; k < node.count; ++k) bound = visit(node.first + k);
    if (node.count > 0) continue;
    Entry near = {entry.node + 1, squared_distance(p, nodes_[entry.node + 1].box)};
    Entry far = {node.first, squared_distance(p, nodes_[node.first].box)};
    if (far.squared_distance < near.squared_distance) std::swap(near, far);
    assert(size + 2 <= max_depth);
    if (far.squared_distance <= bound) stack[size++] = far;
    stack[size++] = near;
  }
}

template <class Visit>
void BoxTree::visit_overlapping(const Box& box, const Visit& visit) const {
  any_in_boxes([&](const Box& of_node) { return overlap(of_node, box); },
               [&](std::uint32_t slot) {
                 visit(slot);
                 return false;
               });
}

template <class Visit>
bool BoxTree::any_on_ray(const Point& p, const Vec3& way, const Visit& visit) const {
  return any_in_boxes([&](const Box& of_node) { return ray_meets(p, way, of_node); }, visit);
}

template <class Meets, class Visit>
bool BoxTree::any_in_boxes(const Meets& meets, const Visit& visit) const {
  if (nodes_.empty()) return false;
  std::array<std::uint32_t, max_depth> stack;
  std::size_t size = 0;
  stack[size++] = 0;
  while (size > 0) {
    const std::uint32_t id = stack[--size];
    const Node& node = nodes_[id];
    if (!meets(node.box)) continue;
    for (std::uint32_t k = 0; k < node.count; ++k) {
      if (visit(node.first + k)) return true;
    }
    if (node.count > 0) continue;
    assert(size + 2 <= max_depth);
    stack[size++] = node.first;
    stack[size++] = id + 1;
  }
  return false;
}

}  // namespace cocoon
