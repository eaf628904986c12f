#include "cocone/max_flow.h"

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

void MaxFlow::adopt_orphans(Tree& tree) {
  while (!orphans_.empty()) {  // those near the root were cut off last
    const std::uint32_t v = orphans_.back();
    orphans_.pop_back();
    if (nodes_[v].parent == cut_off && !keeps_level(tree, v)) move_to_new_level(tree, v);
  }
}

bool MaxFlow::keeps_level(const Tree& tree, std::uint32_t node) {
  Node& n = nodes_[node];
  const std::int32_t above = n.level - tree.sign;
  if (above == 0) return false;
  for (; n.next < end_of_arcs(node); ++n.next) {
    const Arc& arc = arcs_[n.next];
    if (nodes_[arc.to].level != above || room_up(tree, arc) == 0) continue;
    n.parent = n.next;
    return true;
  }
  return false;
}

// Levels only rise: a parent may be found among the node's own children, which are cut off and then
// rise further, until the tree lets go of them.
void MaxFlow::move_to_new_level(Tree& tree, std::uint32_t node) {
  Node& n = nodes_[node];
  std::int32_t lowest = tree.depth + (tree.growing ? 1 : 0);
  std::uint32_t parent = no_arc;
  for (std::uint32_t k = n.first; k < end_of_arcs(node); ++k) {
    const Arc& arc = arcs_[k];
    Node& other = nodes_[arc.to];
    const std::int32_t level = tree.sign * other.level;
    if (level <= 0) continue;
    if (level < lowest && room_up(tree, arc) > 0) {
      lowest = level;
      parent = k;
    }
    if (other.parent == arc.reverse) {
      other.parent = cut_off;
      orphans_.push_back(arc.to);
    }
  }
  if (parent == no_arc) {
    n.level = 0;
    n.parent = no_arc;
    n.next = n.first;
  } else {
    n.next = parent;
    set_level(tree, node, lowest + 1, parent);
  }
}

std::vector<std::uint8_t> MaxFlow::source_side() {
  build_arcs();
  while (!source_.frontier.empty() && !sink_.frontier.empty()) {
    grow(source_.frontier.size() <= sink_.frontier.size() ? source_ : sink_);
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
