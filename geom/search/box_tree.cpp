#include "geom/search/box_tree.h"

#include <algorithm>

namespace cocoon {

namespace {

// The nodes of subtrees with n and n + 1 items.
struct NodeCounts {
  std::size_t of_n;
  std::size_t of_next;
};

NodeCounts node_counts(std::size_t n, std::size_t leaf_size) {
  if (n + 1 <= leaf_size) return {1, 1};
  // Their halves have h or h + 1 items.
  const std::size_t h = n / 2;
  const auto [of_h, of_next] = node_counts(h, leaf_size);
  const std::size_t unequal = 1 + of_h + of_next;
  const std::size_t of_n = n <= leaf_size ? 1 : n % 2 == 0 ? 1 + 2 * of_h : unequal;
  return {of_n, n % 2 == 0 ? unequal : 1 + 2 * of_next};
}

// At the median along the longest axis; equal centers by item, so that the halves are the same with
// every standard library. Returns the size of the first.
template <class Center>
std::size_t split(std::span<Center> centers) {
  Box extent;
  for (const Center& center : centers) extent.include(center.at);
  const Vec3 size = extent.size();
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const std::size_t middle = centers.size() / 2;
  std::nth_element(centers.begin(), centers.begin() + static_cast<std::ptrdiff_t>(middle),
                   centers.end(), [axis](const Center& a, const Center& b) {
                     return a.at[axis] != b.at[axis] ? a.at[axis] < b.at[axis] : a.item < b.item;
                   });
  return middle;
}

}  // namespace

// Nodes in preorder. Where each lies is known beforehand, so that threads build different subtrees.
BoxTree::BoxTree(std::span<const Box> boxes, const Execution& execution) : items_(boxes.size()) {
  constexpr std::size_t least_per_subtree = 1024;
  if (boxes.empty()) return;
  std::vector<Center> centers;
  centers.reserve(boxes.size());
  for (const Box& box : boxes) {
    centers.push_back({box.center(), static_cast<std::uint32_t>(centers.size())});
  }
  nodes_.resize(node_counts(boxes.size(), leaf_size).of_n);
  std::vector<Subtree> subtrees{{centers, 0, 0}};
  std::vector<std::uint32_t> inner;  // nodes above these, parents first
  while (boxes.size() > 2 * least_per_subtree * subtrees.size()) {
    std::vector<Subtree> halves(2 * subtrees.size());
    parallel_chunks(execution, subtrees.size(), 1, [&](std::size_t k, std::size_t) {
      const auto& [all, first, root] = subtrees[k];
      const std::size_t middle = split(all);
      const std::size_t left_nodes = node_counts(middle, leaf_size).of_n;
      nodes_[root].first = root + 1 + static_cast<std::uint32_t>(left_nodes);
      halves[2 * k] = {all.first(middle), first, root + 1};
      halves[2 * k + 1] = {all.subspan(middle), first + middle, nodes_[root].first};
    });
    for (const Subtree& subtree : subtrees) inner.push_back(subtree.root);
    subtrees = std::move(halves);
  }
  parallel_chunks(execution, subtrees.size(), 1,
                  [&](std::size_t k, std::size_t) { build(boxes, subtrees[k]); });
  for (std::size_t k = inner.size(); k-- > 0;) join_boxes(inner[k]);
}

// Returns where the nodes after it are.
std::uint32_t BoxTree::build(std::span<const Box> boxes, const Subtree& subtree) {
  const auto& [all, first, root] = subtree;
  if (all.size() <= leaf_size) {
    make_leaf(boxes, subtree);
    return root + 1;
  }
  const std::size_t middle = split(all);
  const std::uint32_t right = build(boxes, {all.first(middle), first, root + 1});
  nodes_[root].first = right;
  const std::uint32_t end = build(boxes, {all.subspan(middle), first + middle, right});
  join_boxes(root);
  return end;
}

void BoxTree::make_leaf(std::span<const Box> boxes, const Subtree& leaf) {
  Node& node = nodes_[leaf.root];
  for (std::size_t k = 0; k < leaf.centers.size(); ++k) {
    node.box.include(boxes[leaf.centers[k].item]);
    items_[leaf.first + k] = leaf.centers[k].item;
  }
  node.first = static_cast<std::uint32_t>(leaf.first);
  node.count = static_cast<std::uint32_t>(leaf.centers.size());
}

// That of an inner node whose children have theirs.
void BoxTree::join_boxes(std::uint32_t inner) {
  Node& node = nodes_[inner];
  node.box = nodes_[inner + 1].box;
  node.box.include(nodes_[node.first].box);
}

BoxTree tree_of_points(std::span<const Point> points) {
  std::vector<Box> boxes;
  boxes.reserve(points.size());
  for (const Point& p : points) boxes.push_back({p, p});
  return BoxTree(boxes);
}

std::size_t count_near(const BoxTree& tree, std::span<const Point> points, const Point& p,
                       double squared_reach, std::size_t most) {
  std::size_t count = 0;
  tree.visit_near(p, squared_reach, [&](std::uint32_t slot) {
    const bool is_near = squared_distance(points[tree.items()[slot]], p) <= squared_reach;
    if (is_near && count <= most) ++count;
    return count > most ? -1.0 : squared_reach;
  });
  return count;
}

}  // namespace cocoon
