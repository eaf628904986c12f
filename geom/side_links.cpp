#include "geom/side_links.h"

#include <algorithm>

namespace cocoon {
namespace {

constexpr std::uint32_t none = 0xFFFFFFFFU;

// An edge met so far; those with the same smaller vertex make a chain.
struct ChainedEdge {
  VertexId larger;
  SideId first;
  SideId last;
  std::uint32_t next_edge;
};

// Links the sides whose smaller vertex is one of begin .. end - 1.
void link_range(std::span<const Triangle> triangles, std::size_t begin, std::size_t end,
                std::vector<SideId>& links) {
  std::vector<std::uint32_t> chains(end - begin, none);
  std::vector<ChainedEdge> edges;
  edges.reserve(std::min(3 * triangles.size() / 2 + 16, 4 * (end - begin)));
  const auto link = [&](SideId side, VertexId a, VertexId b) {
    const std::size_t smaller = std::min(a, b).index();
    if (smaller < begin || smaller >= end) return;
    const VertexId larger = std::max(a, b);
    std::uint32_t& chain = chains[smaller - begin];
    std::uint32_t edge = a == b ? none : chain;
    while (edge != none && edges[edge].larger != larger) edge = edges[edge].next_edge;
    if (edge == none) {
      links[side] = side;
      if (a == b) return;
      edges.push_back({larger, side, side, chain});
      chain = static_cast<std::uint32_t>(edges.size() - 1);
      return;
    }
    links[side] = edges[edge].first;
    links[edges[edge].last] = side;
    edges[edge].last = side;
  };
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    const auto& [a, b, c] = triangles[t];
    link(3 * t, b, c);
    link(3 * t + 1, c, a);
    link(3 * t + 2, a, b);
  }
}

}  // namespace

std::vector<SideId> side_links(std::span<const Triangle> triangles, std::size_t num_vertices,
                               const Execution& execution) {
  std::vector<SideId> links(3 * triangles.size());
  // Every range of vertices reads all triangles, so there are no more ranges than threads.
  const auto ranges = static_cast<std::size_t>(thread_count(execution));
  parallel_chunks(execution, num_vertices, (num_vertices + ranges - 1) / ranges,
                  [&](std::size_t begin, std::size_t end) {
                    link_range(triangles, begin, end, links);
                  });
  return links;
}

}  // namespace cocoon
