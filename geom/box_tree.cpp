#include "geom/box_tree.h"

#include <algorithm>

namespace cocoon {

BoxTree::BoxTree(std::span<const Box> boxes) : items_(boxes.size()) {
  if (boxes.empty()) return;
  std::vector<Center> centers;
  centers.reserve(boxes.size());
  for (const Box& box : boxes) {
    centers.push_back({box.center(), static_cast<std::uint32_t>(centers.size())});
  }
  nodes_.reserve(2 * (boxes.size() / leaf_size + 1));
  build(boxes, centers, 0);
}

// Appends the subtree of `centers`, which fill the slots from `first` on, in preorder and returns
// its root.
std::uint32_t BoxTree::build(std::span<const Box> boxes, std::span<Center> centers,
                             std::size_t first) {
  const auto id = static_cast<std::uint32_t>(nodes_.size());
  nodes_.emplace_back();
  if (centers.size() <= leaf_size) {
    for (std::size_t k = 0; k < centers.size(); ++k) {
      nodes_[id].box.include(boxes[centers[k].item]);
      items_[first + k] = centers[k].item;
    }
    nodes_[id].first = static_cast<std::uint32_t>(first);
    nodes_[id].count = static_cast<std::uint32_t>(centers.size());
    return id;
  }
  // Split at the median center along the longest axis; equal centers by item, so that the halves
  // are the same with every standard library.
  Box extent;
  for (const Center& center : centers) extent.include(center.at);
  const Vec3 size = extent.size();
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const std::size_t middle = centers.size() / 2;
  std::nth_element(centers.begin(), centers.begin() + static_cast<std::ptrdiff_t>(middle),
                   centers.end(), [axis](const Center& a, const Center& b) {
                     return a.at[axis] != b.at[axis] ? a.at[axis] < b.at[axis] : a.item < b.item;
                   });
  const std::uint32_t left = build(boxes, centers.first(middle), first);
  const std::uint32_t right = build(boxes, centers.subspan(middle), first + middle);
  nodes_[id].box = nodes_[left].box;
  nodes_[id].box.include(nodes_[right].box);
  nodes_[id].first = right;
  return id;
}

BoxTree tree_of_points(std::span<const Point> points) {
  std::vector<Box> boxes;
  boxes.reserve(points.size());
  for (const Point& p : points) boxes.push_back({p, p});
  return BoxTree(boxes);
}

std::size_t count_near(const BoxTree& tree, std::span<const Point> points, const Point& p,
                       double reach, std::size_t most) {
  std::size_t count = 0;
  tree.visit_near(p, reach, [&](std::uint32_t slot) {
    const bool is_near = squared_distance(points[tree.items()[slot]], p) <= reach;
    if (is_near && count <= most) ++count;
    return count > most ? -1.0 : reach;
  });
  return count;
}

}  // namespace cocoon
