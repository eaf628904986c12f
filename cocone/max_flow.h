// Minimum s-t cuts of small sparse graphs with integer capacities.
//
// Integers make the answer exact. Among all minimum cuts the one with the smallest source side is
// unique as a set, so it does not depend on the order of nodes or edges, or on which maximum flow
// was found.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace cocoon {

class MaxFlow {
 public:
  // Nodes are numbered 0 .. count - 1; source and sink are apart.
  explicit MaxFlow(std::size_t count);

  // What it costs if a is on the source side and b on the sink side, or the other way round.
  // Precondition: costs >= 0; the sum of all of them fits into 62 bits.
  void add_edge(std::uint32_t a, std::uint32_t b, std::int64_t cost);
  // What it costs if the node is on the sink side (the source pulls it), or on the source side.
  void pull_to_source(std::uint32_t node, std::int64_t cost) { excess_[node] += cost; }
  void pull_to_sink(std::uint32_t node, std::int64_t cost) { excess_[node] -= cost; }

  // 1 = on the source side of the minimum cut with the smallest source side. Call it once.
  // Complexity: O(nodes^2 edges) at worst, near linear on the cell graphs of this library.
  // Source: Dinic 1970 (blocking flows); Picard & Queyranne 1980 (the smallest source side).
  std::vector<std::uint8_t> source_side();

 private:
  struct Arc {
    std::uint32_t to;
    std::int64_t capacity;  // residual
  };
  struct Step {
    std::uint32_t arc;
    std::uint32_t from;
  };
  void build_arcs();
  bool find_levels();
  void push_blocking_flow();
  void augment(std::vector<Step>& path);

  struct Edge {
    std::uint32_t a;
    std::uint32_t b;
    std::int64_t forth;
    std::int64_t back;
  };
  std::size_t nodes_;
  std::vector<std::int64_t> excess_;
  std::vector<Edge> edges_;
  std::vector<Arc> arcs_;             // arc k and k ^ 1 are each other's reverse
  std::vector<std::uint32_t> first_;  // CSR: arcs of a node in order_
  std::vector<std::uint32_t> order_;
  std::vector<std::uint32_t> level_;
  std::vector<std::uint32_t> next_;
};

}  // namespace cocoon
