#include "cocone/facets/walk_reach.h"

#include <algorithm>

#include "geom/arrays/disjoint_sets.h"
#include "geom/mesh/edge_components.h"

namespace cocoon {
namespace {

constexpr std::size_t triangles_per_chunk = std::size_t{1} << 14;

// Parts that hang together over edges with two candidates are joined where they see each other at
// edges with more. A part seen from one side is 2 * part, from that of half 2 t of its first
// triangle t, or 2 * part + 1.
class Reach {
 public:
  Reach(const LinkedFacets& candidates, const EdgeComponents& parts)
      : candidates_(candidates), parts_(parts), seen_(2 * parts.components.size()) {
    for (std::uint32_t part = 0; part < parts.components.size(); ++part) {
      if (parts.components[part].is_contradictory) seen_.join(2 * part, 2 * part + 1);
    }
  }

  // At the edge of the halfedge: candidates that follow each other around it see each other.
  void join_around(const Triangulation& triangulation, Halfedge halfedge) {
    const std::size_t first = met_.size();
    met_.push_back(2 * triangle_of_halfedge(halfedge));
    turn_about_edge(triangulation, candidates_, met_.back(), halfedge,
                    [&](Half met, Halfedge) { met_.push_back(met); });
    ends_.push_back(met_.size());
    for_each_gap(first, met_.size(), [&](Half a, Half b) { seen_.join(node_of(a), node_of(b)); });
  }

  // What is seen from `start`, and what is passed by who sees it; false if something contradicts
  // itself.
  bool spread(Half start) {
    const std::uint32_t root = seen_.root(node_of(start));
    reached_.resize(2 * parts_.components.size());
    for (std::uint32_t node = 0; node < reached_.size(); ++node) {
      reached_[node] = seen_.root(node) == root ? 1 : 0;
    }
    for (std::size_t node = 0; node < reached_.size(); node += 2) {
      if (reached_[node] + reached_[node + 1] == 2) return false;
    }
    std::size_t first = 0;
    for (const std::size_t end : ends_) {
      for_each_gap(first, end, [&](Half a, Half b) {
        if (reached_[node_of(a)] == 0) return;
        for (std::size_t k = first; k < end; ++k) {
          const std::uint32_t t = triangle_of_half(met_[k]);
          if (t != triangle_of_half(a) && t != triangle_of_half(b)) passed_.push_back(t);
        }
      });
      first = end;
    }
    return std::none_of(passed_.begin(), passed_.end(), [&](std::uint32_t t) {
      return (reached_[node_of(2 * t)] | reached_[node_of(2 * t + 1)]) != 0;
    });
  }

  std::vector<std::uint8_t> states(const Execution& execution) const {
    std::vector<std::uint8_t> states(candidates_.size());
    parallel_chunks(
        execution, states.size(), triangles_per_chunk, [&](std::size_t begin, std::size_t end) {
          for (std::size_t t = begin; t < end; ++t) {
            const std::uint32_t node = 2 * parts_.component_of[t];
            const unsigned turned = parts_.turned[t];
            const unsigned from_front = reached_[node + turned] * walk_state::kept[0];
            const unsigned from_back = reached_[node + (turned ^ 1U)] * walk_state::kept[1];
            states[t] = static_cast<std::uint8_t>(from_front | from_back);
          }
        });
    for (const std::uint32_t t : passed_) states[t] = walk_state::dropped;
    return states;
  }

 private:
  // visit(a, b): the halves that face each other between two candidates that are met one after the
  // other around an edge.
  template <class Visit>
  void for_each_gap(std::size_t first, std::size_t end, Visit visit) const {
    visit(met_[first], met_[first + 1]);
    for (std::size_t k = first + 1; k < end; ++k) {
      visit(other_half(met_[k]), k + 1 < end ? met_[k + 1] : other_half(met_[first]));
    }
  }

  std::uint32_t node_of(Half half) const {
    const std::uint32_t t = triangle_of_half(half);
    return 2 * parts_.component_of[t] + ((half & 1U) ^ parts_.turned[t]);
  }

  const LinkedFacets& candidates_;
  const EdgeComponents& parts_;
  DisjointSets seen_;                  // by node
  std::vector<std::uint8_t> reached_;  // by node
  std::vector<Half> met_;              // around one edge after the other, as they are met
  std::vector<std::size_t> ends_;      // of each edge in met_
  std::vector<std::uint32_t> passed_;  // triangles
};

// That of steep edges after the k-th, which lie apart.
void ask_for_memory(const LinkedFacets& candidates, const EdgeComponents& parts, std::size_t k) {
  constexpr std::size_t links_ahead = 32;
  constexpr std::size_t triangles_ahead = 12;
  const std::vector<Halfedge>& steep = candidates.steep;
  if (k + links_ahead < steep.size()) {
    const Halfedge halfedge = steep[k + links_ahead];
    __builtin_prefetch(&candidates.links[halfedge]);
    __builtin_prefetch(&candidates.corners[triangle_of_halfedge(halfedge)]);
  }
  if (k + triangles_ahead >= steep.size()) return;
  for_each_at_edge(candidates.links, steep[k + triangles_ahead], [&](Halfedge halfedge) {
    const std::uint32_t t = triangle_of_halfedge(halfedge);
    __builtin_prefetch(&candidates.facets[t]);
    __builtin_prefetch(&candidates.mirrors[t]);
    __builtin_prefetch(&candidates.corners[t]);
    __builtin_prefetch(&parts.component_of[t]);
    __builtin_prefetch(&parts.turned[t]);
  });
}

}  // namespace

std::optional<std::vector<std::uint8_t>> walk_reach(const Triangulation& triangulation,
                                                    const LinkedFacets& candidates,
                                                    const VertexSet& umbrella, Half start,
                                                    const Execution& execution) {
  const bool has_rims = std::find(umbrella.begin(), umbrella.end(), 0) != umbrella.end();
  const EdgeComponents parts = edge_components(
      candidates.links, execution,
      [&](Halfedge halfedge) { return !has_rims || is_crossed(candidates, umbrella, halfedge); },
      [&](Halfedge halfedge, Halfedge across) { return run_alike(candidates, halfedge, across); });
  Reach reach(candidates, parts);
  for (std::size_t k = 0; k < candidates.steep.size(); ++k) {
    ask_for_memory(candidates, parts, k);
    const Halfedge halfedge = candidates.steep[k];
    if (candidates.has_two_triangles(halfedge) || !is_crossed(candidates, umbrella, halfedge))
      continue;
    reach.join_around(triangulation, halfedge);
  }
  if (!reach.spread(start)) return std::nullopt;
  return reach.states(execution);
}

}  // namespace cocoon
