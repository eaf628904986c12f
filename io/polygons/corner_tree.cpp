#include "io/polygons/corner_tree.h"

#include <bit>
#include <cmath>
#include <numeric>

namespace cocoon {

CornerTree::CornerTree(std::span<const Planar> points)
    : points_(points), order_(points.size()), place_(points.size()), is_away_(points.size(), 0) {
  std::iota(order_.begin(), order_.end(), 0U);
  nodes_.resize(2 * std::bit_ceil(points.size() + 1));
  build(whole());
  for (std::size_t k = 0; k < order_.size(); ++k) place_[order_[k]] = static_cast<std::uint32_t>(k);
}

// Halves along the longer side of the box.
void CornerTree::build(const Range& range) {
  const std::span<std::uint32_t> all =
      std::span(order_).subspan(range.begin, range.end - range.begin);
  Node& node = nodes_[range.node];
  node.left = static_cast<std::uint32_t>(all.size());
  if (all.empty()) return;
  node.low = node.high = points_[all[0]];
  for (const std::uint32_t i : all) {
    const Planar& p = points_[i];
    node.low = {std::min(node.low.x, p.x), std::min(node.low.y, p.y)};
    node.high = {std::max(node.high.x, p.x), std::max(node.high.y, p.y)};
  }
  if (range.is_leaf()) return;
  const bool by_x = node.high.x - node.low.x >= node.high.y - node.low.y;
  const auto middle = static_cast<std::ptrdiff_t>(range.first().end - range.begin);
  std::nth_element(all.begin(), all.begin() + middle, all.end(),
                   [&](std::uint32_t i, std::uint32_t k) {
                     const double a = by_x ? points_[i].x : points_[i].y;
                     const double b = by_x ? points_[k].x : points_[k].y;
                     return a != b ? a < b : i < k;
                   });
  build(range.first());
  build(range.second());
}

void CornerTree::take_away(std::size_t point) {
  const std::size_t place = place_[point];
  is_away_[point] = 1;
  for (Range range = whole();; range = place < range.first().end ? range.first() : range.second()) {
    --nodes_[range.node].left;
    if (range.is_leaf()) return;
  }
}

// Whether the box lies on the outer side of one of the triangle's sides, or of its box, beyond all
// doubt of rounding: of the box's corners, the one farthest to the left is to the right.
bool CornerTree::is_beside(const Node& node, const std::array<Planar, 3>& triangle) {
  const auto& [a, b, c] = triangle;
  if (node.low.x > std::max({a.x, b.x, c.x}) || node.high.x < std::min({a.x, b.x, c.x}) ||
      node.low.y > std::max({a.y, b.y, c.y}) || node.high.y < std::min({a.y, b.y, c.y})) {
    return true;
  }
  constexpr double rounding = 0x1p-48;     // relative: 2^-50 would do
  constexpr double underflow = 0x1p-1000;  // absolute
  for (std::size_t i = 0; i < 3; ++i) {
    const Planar& from = triangle[i];
    const Planar& to = triangle[(i + 1) % 3];
    const double dx = to.x - from.x;
    const double dy = to.y - from.y;
    const double up = dx * ((dx >= 0 ? node.high.y : node.low.y) - from.y);
    const double right = dy * ((dy >= 0 ? node.low.x : node.high.x) - from.x);
    if (up - right < -(rounding * (std::abs(up) + std::abs(right)) + underflow)) return true;
  }
  return false;
}

}  // namespace cocoon
