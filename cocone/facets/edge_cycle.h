// Whether triangles around a vertex are one fan that closes.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

namespace cocoon {

// `edges`: those opposite to the vertex, directed (`from`, `to`), as the triangles are oriented.
// Whether one leads to the next through all of them, no vertex twice: the triangles are one closed
// umbrella. False for none. Complexity: O(k^2) for k edges, six as a rule.
template <class Edge>
bool is_one_cycle(std::span<const Edge> edges) {
  if (edges.empty()) return false;
  auto at = edges.front().to;
  for (std::size_t count = 1; count < edges.size(); ++count) {
    const auto next =
        std::find_if(edges.begin(), edges.end(), [&](const Edge& e) { return e.from == at; });
    if (next == edges.begin() || next == edges.end()) return false;
    at = next->to;
  }
  return at == edges.front().from;
}

}  // namespace cocoon
