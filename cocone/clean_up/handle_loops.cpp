#include "cocone/clean_up/handle_loops.h"

#include <algorithm>
#include <array>
#include <span>

#include "cocone/facets/surface_walk.h"
#include "delaunay/circulate.h"
#include "geom/arrays/sort_by_vertex.h"
#include "geom/parallel/parallel_list.h"

namespace cocoon {
namespace {

using Ranks = std::array<std::uint32_t, 3>;  // of the corners of a facet, increasing; 0: none

// Of the surface facets at vertices of the region that are next to its cells.
std::vector<Ranks> facets_by_rank(const Triangulation& triangulation, const DoubtfulRegion& region,
                                  const IdVector<CellId, std::uint8_t>& out,
                                  const Execution& execution) {
  constexpr std::size_t cells_per_chunk = 4096;
  const auto find = [&](std::size_t begin, std::size_t end, std::vector<Ranks>& facets) {
    for (const CellId c : std::span(region.cells).subspan(begin, end - begin)) {
      if (out[c] != 0) continue;
      for (int i = 0; i < 4; ++i) {
        if (out[triangulation.neighbor(c, i)] == 0) continue;
        const auto [u, v, w] = triangulation.facet_vertices(facet_id(c, i));
        Ranks ranks = {region.rank[u], region.rank[v], region.rank[w]};
        std::sort(ranks.begin(), ranks.end());
        if (ranks[1] != 0) facets.push_back(ranks);
      }
    }
  };
  return parallel_list<Ranks>(execution, region.cells.size(), cells_per_chunk, find);
}

// For each rank the vertices that come later and have an edge with it, each once, increasing.
class LaterNeighbors {
 public:
  LaterNeighbors(const std::vector<Ranks>& facets, std::size_t ranks) {
    begin_ = sort_by_vertex(
        facets.size(), ranks + 1, {}, [&](std::size_t count) { others_.resize(count); },
        [&](std::size_t begin, std::size_t end, auto put) {
          const auto put_edge = [&](std::uint32_t from, std::uint32_t to) {
            if (from != 0) put(VertexId(from), [&](std::size_t place) { others_[place] = to; });
          };
          for (std::size_t k = begin; k < end; ++k) {
            const auto& [a, b, c] = facets[k];
            put_edge(a, b);
            put_edge(a, c);
            put_edge(b, c);
          }
        });
    end_.assign(begin_.begin() + 1, begin_.end());
    for (std::size_t a = 1; a < end_.size(); ++a) {
      const auto first = others_.begin() + begin_[a];
      const auto last = others_.begin() + end_[a];
      std::sort(first, last);
      end_[a] = static_cast<std::uint32_t>(std::unique(first, last) - others_.begin());
    }
  }
  std::span<const std::uint32_t> of(std::uint32_t a) const {
    return std::span(others_).subspan(begin_[a], end_[a] - begin_[a]);
  }
  bool contain(std::uint32_t a, std::uint32_t b) const {
    const auto others = of(a);
    return std::binary_search(others.begin(), others.end(), b);
  }

 private:
  std::vector<std::uint32_t> begin_;
  std::vector<std::uint32_t> end_;
  std::vector<std::uint32_t> others_;
};

// Loops whose first vertex is that of rank a; `facets` in order.
void add_loops_from(std::uint32_t a, const LaterNeighbors& later, const std::vector<Ranks>& facets,
                    const DoubtfulRegion& region, std::vector<Triangle>& loops) {
  for (const std::uint32_t b : later.of(a)) {
    for (const std::uint32_t c : later.of(b)) {
      if (!later.contain(a, c)) continue;
      if (std::binary_search(facets.begin(), facets.end(), Ranks{a, b, c})) continue;
      loops.push_back({region.vertices[a - 1], region.vertices[b - 1], region.vertices[c - 1]});
    }
  }
}

bool has(const Triangle& corners, VertexId v) {
  return corners[0] == v || corners[1] == v || corners[2] == v;
}

// From a to b, rather than from b to a?
bool runs(const Triangle& corners, VertexId a, VertexId b) {
  return (corners[0] == a && corners[1] == b) || (corners[1] == a && corners[2] == b) ||
         (corners[2] == a && corners[0] == b);
}

}  // namespace

std::vector<Triangle> HandleLoops::find(const DoubtfulRegion& region,
                                        const Execution& execution) const {
  std::vector<Ranks> facets = facets_by_rank(triangulation_, region, out_, execution);
  const LaterNeighbors later(facets, region.vertices.size());
  std::erase_if(facets, [](const Ranks& ranks) { return ranks[0] == 0; });
  std::sort(facets.begin(), facets.end());
  constexpr std::size_t ranks_per_chunk = 1024;
  return parallel_list<Triangle>(
      execution, region.vertices.size(), ranks_per_chunk,
      [&](std::size_t begin, std::size_t end, std::vector<Triangle>& loops) {
        for (std::size_t k = begin; k < end; ++k) {
          add_loops_from(static_cast<std::uint32_t>(k + 1), later, facets, region, loops);
        }
      });
}

bool HandleLoops::is_handle(const Triangle& loop, std::size_t most_facets) {
  if (mark_.size() == 0) mark_ = ZeroedArray<FacetId, std::uint8_t>(4 * triangulation_.num_cells());
  left_ = {{}, 0, 1};
  right_ = {{}, 0, 2};
  bool met = false;
  if (begin(loop)) {
    const auto can_go_on = [&](const Flood& flood) {
      return flood.next < flood.facets.size() && flood.facets.size() <= most_facets;
    };
    while (!met && can_go_on(left_) && can_go_on(right_)) {
      met = grow(left_, loop) || grow(right_, loop);
    }
  }
  for (const Flood* flood : {&left_, &right_}) {
    for (const FacetId f : flood->facets) mark_[f] = 0;
  }
  return met;
}

// The two surface facets at each edge of the loop. False if these are not two.
bool HandleLoops::begin(const Triangle& loop) {
  for (std::size_t k = 0; k < 3; ++k) {
    const VertexId a = loop[k];
    const VertexId b = loop[(k + 1) % 3];
    std::size_t left = 0;
    std::size_t right = 0;
    for (const CellId c : stars_.star(a)) {
      const Cell& cell = triangulation_.cell(c);
      if (out_[c] != 0 || !has_vertex(cell, b)) continue;
      for (int i = 0; i < 4; ++i) {
        const VertexId opposite = cell.vertices[static_cast<std::size_t>(i)];
        if (opposite == a || opposite == b || out_[triangulation_.neighbor(c, i)] == 0) continue;
        const FacetId f = facet_id(c, i);
        const bool is_left = runs(triangulation_.facet_vertices(f), a, b);
        ++(is_left ? left : right);
        enter(is_left ? left_ : right_, f);
      }
    }
    if (left != 1 || right != 1) return false;
  }
  return true;
}

// Was it the other flood that had been there?
bool HandleLoops::enter(Flood& flood, FacetId f) {
  if (mark_[f] != 0) return mark_[f] != flood.mark;
  mark_[f] = flood.mark;
  flood.facets.push_back(f);
  return false;
}

// By one ring, but not over the loop. Do the floods meet? Whole rings do not depend on the order of
// their facets.
bool HandleLoops::grow(Flood& flood, const Triangle& loop) {
  for (const std::size_t end = flood.facets.size(); flood.next < end; ++flood.next) {
    const FacetId f = flood.facets[flood.next];
    const Triangle corners = triangulation_.facet_vertices(f);
    for (std::size_t k = 0; k < 3; ++k) {
      const VertexId a = corners[k];
      const VertexId b = corners[(k + 1) % 3];
      if (has(loop, a) && has(loop, b)) continue;
      if (enter(flood, next_surface_facet(triangulation_, out_, f, a, b))) return true;
    }
  }
  return false;
}

}  // namespace cocoon
