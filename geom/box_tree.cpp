#include "geom/box_tree.h"

#include <algorithm>
#include <numeric>

namespace cocoon {

BoxTree::BoxTree(std::span<const Box> boxes) : items_(boxes.size()) {
  std::iota(items_.begin(), items_.end(), 0U);
  if (boxes.empty()) return;
  nodes_.reserve(2 * (boxes.size() / leaf_size + 1));
  build(boxes, 0, boxes.size());
}

// Appends the subtree of the slots [begin, end) in preorder and returns its root.
std::uint32_t BoxTree::build(std::span<const Box> boxes, std::size_t begin, std::size_t end) {
  const auto id = static_cast<std::uint32_t>(nodes_.size());
  nodes_.emplace_back();
  Box box;
  Box centers;
  for (std::size_t slot = begin; slot < end; ++slot) {
    box.include(boxes[items_[slot]]);
    centers.include(boxes[items_[slot]].center());
  }
  nodes_[id].box = box;
  if (end - begin <= leaf_size) {
    nodes_[id].first = static_cast<std::uint32_t>(begin);
    nodes_[id].count = static_cast<std::uint32_t>(end - begin);
    return id;
  }
  // Split at the median center along the longest axis; equal centers by item, so that the halves
  // are the same with every standard library.
  const Vec3 size = centers.size();
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const std::size_t middle = begin + (end - begin) / 2;
  const auto at = [this](std::size_t slot) {
    return items_.begin() + static_cast<std::ptrdiff_t>(slot);
  };
  std::nth_element(at(begin), at(middle), at(end), [&](std::uint32_t a, std::uint32_t b) {
    const double center_a = boxes[a].center()[axis];
    const double center_b = boxes[b].center()[axis];
    return center_a != center_b ? center_a < center_b : a < b;
  });
  build(boxes, begin, middle);
  const std::uint32_t right = build(boxes, middle, end);
  nodes_[id].first = right;
  return id;
}

}  // namespace cocoon
