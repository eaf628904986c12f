#include "geom/side_links.h"

#include <algorithm>

namespace cocoon {
namespace {

constexpr std::uint32_t none = 0xFFFFFFFFU;
// A vertex with more edges to larger ones than this has the rest of them sorted.
constexpr std::uint8_t longest_chain = 32;

// An edge met so far; those with the same smaller vertex make a chain.
struct ChainedEdge {
  VertexId larger;
  SideId first;
  SideId last;
  std::uint32_t next_edge;
};

struct SortedSide {
  VertexId smaller;
  VertexId larger;
  SideId side;
  friend auto operator<=>(const SortedSide&, const SortedSide&) = default;
};

// Links the sides whose smaller vertex is one of begin .. end - 1.
class Linker {
 public:
  Linker(std::size_t begin, std::size_t end, std::size_t expected_edges, std::vector<SideId>& links)
      : begin_(begin), links_(links), chains_(end - begin, none), lengths_(end - begin, 0) {
    edges_.reserve(expected_edges);
  }

  void add(SideId side, VertexId a, VertexId b) {
    const std::size_t smaller = std::min(a, b).index();
    if (smaller - begin_ >= chains_.size()) return;  // below the range it wraps around
    links_[side] = side;
    if (a == b) return;
    const VertexId larger = std::max(a, b);
    std::uint32_t& chain = chains_[smaller - begin_];
    std::uint32_t edge = chain;
    while (edge != none && edges_[edge].larger != larger) edge = edges_[edge].next_edge;
    if (edge != none) {
      append(edge, side);
    } else if (lengths_[smaller - begin_] == longest_chain) {
      sorted_.push_back({VertexId(smaller), larger, side});
    } else {
      ++lengths_[smaller - begin_];
      edges_.push_back({larger, side, side, chain});
      chain = static_cast<std::uint32_t>(edges_.size() - 1);
    }
  }

  void finish() {
    std::sort(sorted_.begin(), sorted_.end());
    for (std::size_t begin = 0, end = 0; begin < sorted_.size(); begin = end) {
      while (end < sorted_.size() && sorted_[end].smaller == sorted_[begin].smaller &&
             sorted_[end].larger == sorted_[begin].larger) {
        ++end;
      }
      for (std::size_t k = begin; k < end; ++k) {
        links_[sorted_[k].side] = sorted_[k + 1 < end ? k + 1 : begin].side;
      }
    }
  }

 private:
  void append(std::uint32_t edge, SideId side) {
    links_[side] = edges_[edge].first;
    links_[edges_[edge].last] = side;
    edges_[edge].last = side;
  }

  std::size_t begin_;
  std::vector<SideId>& links_;
  std::vector<std::uint32_t> chains_;  // first edge of each vertex
  std::vector<std::uint8_t> lengths_;
  std::vector<ChainedEdge> edges_;
  std::vector<SortedSide> sorted_;  // of edges beyond the chains
};

}  // namespace

std::vector<SideId> side_links(std::span<const Triangle> triangles, std::size_t num_vertices,
                               const Execution& execution) {
  std::vector<SideId> links(3 * triangles.size());
  // Every range of vertices reads all triangles, so there are no more ranges than threads.
  const auto ranges = static_cast<std::size_t>(thread_count(execution));
  parallel_chunks(execution, num_vertices, (num_vertices + ranges - 1) / ranges,
                  [&](std::size_t begin, std::size_t end) {
                    // A closed surface has three edges for two triangles; what is not used of this
                    // costs nothing, growing beyond it would double the memory.
                    Linker linker(begin, end, 2 * triangles.size() / ranges, links);
                    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
                      const auto& [a, b, c] = triangles[t];
                      linker.add(3 * t, b, c);
                      linker.add(3 * t + 1, c, a);
                      linker.add(3 * t + 2, a, b);
                    }
                    linker.finish();
                  });
  return links;
}

}  // namespace cocoon
