#include "cocone/energy/max_flow.h"

#include <algorithm>
#include <limits>

namespace cocoon {
namespace {

constexpr std::uint32_t no_arc = 0xFFFFFFFFU;   // of roots, and of nodes in no tree
constexpr std::uint32_t cut_off = 0xFFFFFFFEU;  // the parent of orphans

}  // namespace

void MaxFlow::add_edge(std::uint32_t a, std::uint32_t b, std::int64_t cost) {
  if (cost > 0 && a != b) edges_.push_back({a, b, cost});
}

void MaxFlow::build_arcs() {
  const std::size_t count = excess_.size();
  nodes_.assign(count + 1, {0, 0, no_arc, 0});
  for (const Edge& e : edges_) {
    ++nodes_[e.a].next;
    ++nodes_[e.b].next;
  }
  for (std::size_t v = 0; v < count; ++v) {
    nodes_[v + 1].first = nodes_[v].first + nodes_[v].next;
    nodes_[v].next = nodes_[v].first;
  }
  arcs_.resize(2 * edges_.size());
  for (const Edge& e : edges_) {
    const std::uint32_t forth = nodes_[e.a].next++;
    const std::uint32_t back = nodes_[e.b].next++;
    arcs_[forth] = {e.b, back, e.cost};
    arcs_[back] = {e.a, forth, e.cost};
  }
  edges_ = {};
  for (std::uint32_t v = 0; v < count; ++v) {
    nodes_[v].next = nodes_[v].first;
    if (excess_[v] == 0) continue;
    Tree& tree = excess_[v] > 0 ? source_ : sink_;
    set_level(tree, v, 1, no_arc);
  }
}

void MaxFlow::set_level(Tree& tree, std::uint32_t node, std::int32_t level, std::uint32_t parent) {
  nodes_[node].level = tree.sign * level;
  nodes_[node].parent = parent;
  if (level == tree.depth) tree.frontier.push_back(node);
  if (level == tree.depth + 1) tree.next.push_back(node);
}

// By one level. Nodes that come to the searched level meanwhile are searched from, too.
void MaxFlow::grow(Tree& tree) {
  tree.growing = true;
  for (std::size_t i = 0; i < tree.frontier.size(); ++i) search_from(tree, tree.frontier[i]);
  tree.growing = false;
  ++tree.depth;
  tree.frontier.swap(tree.next);
  tree.next.clear();
}

void MaxFlow::search_from(Tree& tree, std::uint32_t node) {
  const std::int32_t level = tree.sign * tree.depth;
  for (std::uint32_t k = nodes_[node].first; k < end_of_arcs(node);) {
    if (nodes_[node].level != level) return;
    const std::uint32_t to = arcs_[k].to;
    const std::int32_t other = nodes_[to].level * tree.sign;
    if (other > 0 || room_down(tree, arcs_[k]) == 0) {
      ++k;
    } else if (other == 0) {
      nodes_[to].next = nodes_[to].first;
      set_level(tree, to, tree.depth + 1, arcs_[k].reverse);
      ++k;
    } else if (tree.sign > 0) {
      augment(node, k, to);
    } else {
      augment(to, arcs_[k].reverse, node);
    }
  }
}

std::int64_t MaxFlow::bottleneck(const Tree& tree, std::uint32_t node) const {
  std::int64_t amount = std::numeric_limits<std::int64_t>::max();
  std::uint32_t v = node;
  for (; nodes_[v].parent != no_arc; v = arcs_[nodes_[v].parent].to) {
    amount = std::min(amount, room_up(tree, arcs_[nodes_[v].parent]));
  }
  return std::min(amount, tree.sign * excess_[v]);
}

// From the node to the root of its tree, or the other way round; cuts off what is saturated.
void MaxFlow::push(Tree& tree, std::uint32_t node, std::int64_t amount) {
  std::uint32_t v = node;
  while (nodes_[v].parent != no_arc) {
    Arc& arc = arcs_[nodes_[v].parent];
    arc.capacity += tree.sign * amount;
    arcs_[arc.reverse].capacity -= tree.sign * amount;
    if (room_up(tree, arc) == 0) {
      nodes_[v].parent = cut_off;
      orphans_.push_back(v);
    }
    v = arc.to;
  }
  excess_[v] -= tree.sign * amount;
  if (excess_[v] == 0) {
    nodes_[v].parent = cut_off;
    orphans_.push_back(v);
  }
}

// Over the arc of `from`, a node of the source's tree, to `to`, one of the sink's.
void MaxFlow::augment(std::uint32_t from, std::uint32_t arc, std::uint32_t to) {
  const std::int64_t amount =
      std::min(arcs_[arc].capacity, std::min(bottleneck(source_, from), bottleneck(sink_, to)));
  arcs_[arc].capacity -= amount;
  arcs_[arcs_[arc].reverse].capacity += amount;
  push(source_, from, amount);
  adopt_orphans(source_);
  push(sink_, to, amount);
  adopt_orphans(sink_);
}

// From the root on, so that each node is looked at once: those that cannot keep their level leave
// the tree with what hangs on them. Then they come back, the lowest first, where the tree still
// reaches them.
void MaxFlow::adopt_orphans(Tree& tree) {
  lost_.clear();
  std::vector<std::uint32_t> children;
  std::vector<std::uint32_t> next_children;
  while (!orphans_.empty() || !children.empty()) {
    // Of the saturated path the node nearest to the root was cut off last.
    const std::int32_t level =
        level_of(tree, children.empty() ? orphans_.back() : children.front());
    while (!orphans_.empty() && level_of(tree, orphans_.back()) <= level) {
      children.push_back(orphans_.back());
      orphans_.pop_back();
    }
    for (const std::uint32_t v : children) {
      if (!keeps_level(tree, v)) release(v, next_children);
    }
    children.swap(next_children);
    next_children.clear();
  }
  bring_back(tree);
}

// Of the node's arcs from `next` on the first to a node of that level from which it can hang.
std::uint32_t MaxFlow::first_arc_to_level(const Tree& tree, std::uint32_t node,
                                          std::int32_t level) const {
  std::uint32_t k = nodes_[node].next;
  const std::uint32_t end = end_of_arcs(node);
  while (k < end && (level_of(tree, arcs_[k].to) != level || room_up(tree, arcs_[k]) == 0)) {
    ++k;
  }
  return k;
}

bool MaxFlow::keeps_level(const Tree& tree, std::uint32_t node) {
  Node& n = nodes_[node];
  const std::int32_t above = level_of(tree, node) - 1;
  if (above == 0) return false;
  n.next = first_arc_to_level(tree, node, above);
  if (n.next == end_of_arcs(node)) return false;
  n.parent = n.next;
  return true;
}

// Takes the node from its tree and cuts off its children.
void MaxFlow::release(std::uint32_t node, std::vector<std::uint32_t>& children) {
  Node& n = nodes_[node];
  for (std::uint32_t k = n.first; k < end_of_arcs(node); ++k) {
    Node& other = nodes_[arcs_[k].to];
    if (other.parent != arcs_[k].reverse) continue;
    other.parent = cut_off;
    children.push_back(arcs_[k].to);
  }
  n = {n.first, n.first, no_arc, 0};
  lost_.push_back(node);
}

void MaxFlow::bring_back(Tree& tree) {
  if (lost_.empty()) return;
  const std::int32_t limit = tree.depth + (tree.growing ? 1 : 0);
  const auto at_level = [&](std::int32_t level) -> std::vector<std::uint32_t>& {
    const auto index = static_cast<std::size_t>(level);
    if (index >= returning_.size()) returning_.resize(index + 1);
    return returning_[index];
  };
  std::int32_t level = limit + 1;
  for (const std::uint32_t v : lost_) {
    std::int32_t lowest = limit;
    for (std::uint32_t k = nodes_[v].first; k < end_of_arcs(v); ++k) {
      const std::int32_t other = level_of(tree, arcs_[k].to);
      if (other > 0 && other < lowest && room_up(tree, arcs_[k]) > 0) lowest = other;
    }
    if (lowest == limit) continue;
    at_level(lowest + 1).push_back(v);
    level = std::min(level, lowest + 1);
  }
  for (; level <= limit; ++level) {
    for (std::size_t i = 0; i < at_level(level).size(); ++i) {
      const std::uint32_t v = at_level(level)[i];
      if (nodes_[v].level != 0) continue;
      nodes_[v].next = first_arc_to_level(tree, v, level - 1);
      set_level(tree, v, level, nodes_[v].next);
      for (std::uint32_t k = nodes_[v].first; level < limit && k < end_of_arcs(v); ++k) {
        const bool follows = nodes_[arcs_[k].to].level == 0 && room_down(tree, arcs_[k]) > 0;
        if (follows) at_level(level + 1).push_back(arcs_[k].to);
      }
    }
    at_level(level).clear();
  }
}

std::vector<std::uint8_t> MaxFlow::source_side() {
  build_arcs();
  while (!source_.frontier.empty() && !sink_.frontier.empty()) {
    grow(source_.depth <= sink_.depth ? source_ : sink_);
  }
  // The source's tree is finished only if it was the one that could not grow.
  std::vector<std::uint8_t> side(excess_.size(), 0);
  std::vector<std::uint32_t> reached;
  for (std::uint32_t v = 0; v < side.size(); ++v) {
    if (nodes_[v].level <= 0) continue;
    side[v] = 1;
    reached.push_back(v);
  }
  while (!reached.empty()) {
    const std::uint32_t v = reached.back();
    reached.pop_back();
    for (std::uint32_t k = nodes_[v].first; k < end_of_arcs(v); ++k) {
      const Arc& arc = arcs_[k];
      if (side[arc.to] != 0 || arc.capacity == 0) continue;
      side[arc.to] = 1;
      reached.push_back(arc.to);
    }
  }
  return side;
}

}  // namespace cocoon
