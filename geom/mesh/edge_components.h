// The parts of a surface that hang together by edges, and how their triangles are turned.
//
// Use this to count or orient parts; for the triangles across edges themselves see halfedges.h.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "geom/arrays/turned_sets.h"
#include "geom/arrays/visit_where.h"
#include "geom/execution.h"
#include "geom/mesh/halfedges.h"
#include "geom/triangle_mesh.h"

namespace cocoon {

struct EdgeComponent {
  std::size_t triangles = 0;
  std::size_t turned = 0;         // of them, see below
  bool is_contradictory = false;  // no way to turn them that agrees everywhere: one-sided
};

struct EdgeComponents {
  std::vector<EdgeComponent> components;    // in the order of their first triangles
  std::vector<std::uint32_t> component_of;  // per triangle
  // Per triangle: 1 if it runs against the first one of its component. Without meaning where that
  // is contradictory.
  std::vector<std::uint8_t> turned;
};

// Triangles are connected across edges with exactly two of them, and agree if they run through
// these in opposite directions. Complexity: O(triangles), parallel.
EdgeComponents edge_components(const TriangleMesh& mesh, const HalfedgeRings& rings,
                               const Execution& execution = {});

namespace edge_components_detail {

constexpr std::size_t triangles_per_chunk = std::size_t{1} << 15;

// Two triangles that hang together, turned against each other or not.
struct Join {
  std::uint32_t triangle;
  std::uint32_t other;
  std::uint32_t turned;
};

// What is known of some consecutive triangles without the others.
struct Chunk {
  std::vector<std::uint32_t> seeds;         // triangles without an earlier neighbor; increasing
  std::vector<Join> to_earlier;             // to triangles of chunks before
  std::vector<std::uint32_t> contradicted;  // seeds of what has no two sides
  // Words of seeds that met lately; they are joined when it is known who is a seed.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> meetings;
};

// Triangles take over the seed of their first earlier neighbor; where other neighbors have other
// seeds, these are joined.
class Seeds {
 public:
  explicit Seeds(std::size_t num_triangles);

  // Joins the triangles begin .. end with those before them in this range, and notes what hangs
  // together with earlier ones: from the second of two halfedges.
  template <class Connects, class IsTurned>
  void join_range(std::span<const Halfedge> links, std::size_t begin, std::size_t end,
                  Connects connects, IsTurned is_turned) {
    Chunk& chunk = chunks_[begin / triangles_per_chunk];
    constexpr std::size_t triangles_per_block = 64;
    const auto is_second = [&](Halfedge halfedge) { return links[halfedge] < halfedge; };
    const auto join_across = [&](Halfedge halfedge) {
      const Halfedge across = links[halfedge];
      if (links[across] != halfedge || !connects(halfedge)) return;
      const Join join{triangle_of_halfedge(halfedge), triangle_of_halfedge(across),
                      is_turned(halfedge, across) ? 1U : 0U};
      if (join.other < begin) {
        chunk.to_earlier.push_back(join);
      } else {
        take_over(join, chunk);
      }
    };
    for (std::size_t first = begin; first < end; first += triangles_per_block) {
      const std::size_t last = std::min(first + triangles_per_block, end);
      visit_every_other(static_cast<Halfedge>(3 * first), static_cast<Halfedge>(3 * last),
                        is_second, join_across);
      list_seeds(first, last, chunk);
      for (const auto& [word, told] : chunk.meetings) join(word, told, chunk);
      chunk.meetings.clear();
    }
  }

  EdgeComponents number(const Execution& execution) &&;

 private:
  void take_over(const Join& join, Chunk& chunk) {
    const std::uint32_t told = sets_.word(join.other) ^ join.turned;
    const std::uint32_t word = sets_.word(join.triangle);
    const bool is_first =
        word == TurnedSets::word_of_root(join.triangle) && join.other != join.triangle;
    // Whether it is the first neighbor cannot be foreseen, that it says the same nearly always can.
    const std::uint32_t kept = is_first ? told : word;
    sets_.hang(join.triangle, kept);
    if (kept != told) chunk.meetings.emplace_back(kept, told);
  }

  void join(std::uint32_t word, std::uint32_t other, Chunk& chunk);
  void list_seeds(std::size_t begin, std::size_t end, Chunk& chunk);
  void flatten();

  TurnedSets sets_;  // triangles hang under seeds, and these under each other
  std::vector<Chunk> chunks_;
};

}  // namespace edge_components_detail

// The same for any triangles whose halfedges are linked as halfedge_links() does: of two alone on
// an edge, connects(halfedge) tells whether their triangles are connected, and is_turned(halfedge,
// across) whether they disagree; both the same from both sides, and called by several threads. Fast
// where neighbors have near numbers. Precondition: fewer than 2^31 triangles.
template <class Connects, class IsTurned>
EdgeComponents edge_components(std::span<const Halfedge> links, const Execution& execution,
                               Connects connects, IsTurned is_turned) {
  edge_components_detail::Seeds seeds(links.size() / 3);
  parallel_chunks(execution, links.size() / 3, edge_components_detail::triangles_per_chunk,
                  [&](std::size_t begin, std::size_t end) {
                    seeds.join_range(links, begin, end, connects, is_turned);
                  });
  return std::move(seeds).number(execution);
}

}  // namespace cocoon
