// Minimum s-t cuts of small sparse graphs with integer capacities.
//
// Integers make the answer exact. Among all minimum cuts the one with the smallest source side is
// unique as a set, so it does not depend on the order of nodes or edges, or on which maximum flow
// was found.
//
// Two trees grow toward each other by whole levels, from what the source pulls and from what the
// sink pulls, over arcs that are not saturated. Where they meet, flow is pushed from root to root;
// nodes cut off by what that saturates look for a new parent, at the same level if they can. So the
// searches go on where they were, which pays since nearly all paths in graphs of cells are short.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace cocoon {

class MaxFlow {
 public:
  // Nodes are numbered 0 .. count - 1; source and sink are apart. Precondition: count < 2^31.
  explicit MaxFlow(std::size_t count) : excess_(count, 0) {}

  // What it costs if a is on the source side and b on the sink side, or the other way round.
  // Precondition: costs >= 0; the sum of all of them fits into 62 bits.
  void add_edge(std::uint32_t a, std::uint32_t b, std::int64_t cost);
  // What it costs if the node is on the sink side (the source pulls it), or on the source side.
  void pull_to_source(std::uint32_t node, std::int64_t cost) { excess_[node] += cost; }
  void pull_to_sink(std::uint32_t node, std::int64_t cost) { excess_[node] -= cost; }

  // 1 = on the source side of the minimum cut with the smallest source side. Call it once.
  // Complexity: O(nodes^2 edges) at worst, near linear on the cell graphs of this library.
  // Source: Goldberg, Hed, Kaplan, Tarjan & Werneck 2011 (incremental breadth-first search);
  // Picard & Queyranne 1980 (the smallest source side).
  std::vector<std::uint8_t> source_side();

 private:
  struct Edge {
    std::uint32_t a;
    std::uint32_t b;
    std::int64_t cost;
  };
  struct Arc {
    std::uint32_t to;
    std::uint32_t reverse;
    std::int64_t capacity;  // residual
  };
  struct Node {
    std::uint32_t first;   // its arcs end where those of the next node begin
    std::uint32_t next;    // arcs before it lead to no parent at this level
    std::uint32_t parent;  // the arc to it; no_arc: a root or no parent
    std::int32_t level;    // from 1 in the source's tree, from -1 in the sink's; 0: in none
  };
  // The two trees differ by the direction of their arcs. Sign: of the levels.
  struct Tree {
    std::int32_t sign;
    std::int32_t depth = 1;               // nodes of this level are still to be searched from
    std::vector<std::uint32_t> frontier;  // those, and some that have left the level
    std::vector<std::uint32_t> next;      // of the level after it, while the tree grows
    bool growing = false;
  };

  void build_arcs();
  void grow(Tree& tree);
  void search_from(Tree& tree, std::uint32_t node);
  void augment(std::uint32_t from, std::uint32_t arc, std::uint32_t to);
  std::int64_t bottleneck(const Tree& tree, std::uint32_t node) const;
  void push(Tree& tree, std::uint32_t node, std::int64_t amount);
  void adopt_orphans(Tree& tree);
  bool keeps_level(const Tree& tree, std::uint32_t node);
  void release(std::uint32_t node, std::vector<std::uint32_t>& children);
  void bring_back(Tree& tree);
  std::uint32_t first_arc_to_level(const Tree& tree, std::uint32_t node, std::int32_t level) const;
  void set_level(Tree& tree, std::uint32_t node, std::int32_t level, std::uint32_t parent);

  std::int32_t level_of(const Tree& tree, std::uint32_t node) const {
    return tree.sign * nodes_[node].level;
  }
  std::uint32_t end_of_arcs(std::uint32_t node) const { return nodes_[node + 1].first; }
  // How much more can flow over an arc of a node: away from it in the source's tree, to it in the
  // sink's.
  std::int64_t room_down(const Tree& tree, const Arc& arc) const {
    return tree.sign > 0 ? arc.capacity : arcs_[arc.reverse].capacity;
  }
  std::int64_t room_up(const Tree& tree, const Arc& arc) const {
    return tree.sign > 0 ? arcs_[arc.reverse].capacity : arc.capacity;
  }

  std::vector<std::int64_t> excess_;  // what is left of the pulls: > 0 toward the source
  std::vector<Edge> edges_;
  std::vector<Arc> arcs_;
  std::vector<Node> nodes_;  // and one past the end
  Tree source_{1, 1, {}, {}, false};
  Tree sink_{-1, 1, {}, {}, false};
  std::vector<std::uint32_t> orphans_;
  std::vector<std::uint32_t> lost_;                    // that could not keep their level
  std::vector<std::vector<std::uint32_t>> returning_;  // by new level
};

}  // namespace cocoon
