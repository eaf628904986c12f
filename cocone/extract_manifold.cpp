#include "cocone/extract_manifold.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

#include "cocone/cell_order.h"
#include "delaunay/circulate.h"

namespace cocoon {
namespace {

// What is known of a candidate, from one of its sides.
enum class HalfState : std::uint8_t { open, proposed, kept, kept_from_back, dropped };

// A candidate seen from one of its sides: 2 * triangle, from the cell that numbers the facet, or
// 2 * triangle + 1, from the one behind.
using Half = std::uint32_t;

constexpr std::uint32_t triangle_of_half(Half half) { return half / 2; }
constexpr Half other_half(Half half) { return half ^ 1U; }

class Walk {
 public:
  Walk(const Triangulation& triangulation, const LinkedFacets& candidates,
       const VertexSet& umbrella)
      : triangulation_(triangulation),
        candidates_(candidates),
        umbrella_(umbrella),
        states_(2 * candidates.size(), HalfState::open),
        on_surface_(triangulation.num_vertices(), 0) {}

  void run() {
    walk_from(hull_starts());
    walk_from(other_starts());
    keep_unwalked();
  }

  // The kept halves; of triangles off the surface either. From which side a triangle is kept cannot
  // be foreseen: no branch depends on it.
  std::vector<FacetId> halves() const {
    std::vector<FacetId> halves(candidates_.size());
    for (std::uint32_t t = 0; t < candidates_.size(); ++t) {
      const auto back = static_cast<Half>(states_[2 * t] == HalfState::kept ? 0 : 1);
      const std::array<FacetId, 2> sides = {candidates_.facets[t], candidates_.mirrors[t]};
      halves[t] = sides[back];
    }
    return halves;
  }
  std::vector<std::uint8_t> off_surface() const {
    std::vector<std::uint8_t> flags(candidates_.size());
    for (std::uint32_t t = 0; t < candidates_.size(); ++t) flags[t] = is_kept(t) ? 0 : 1;
    return flags;
  }
  std::size_t walks() const { return walks_; }
  std::size_t unwalked() const { return unwalked_; }
  std::size_t back_contacts() const { return back_contacts_; }

 private:
  FacetId facet_of(Half h) const {
    const std::uint32_t t = triangle_of_half(h);
    return (h & 1U) == 0 ? candidates_.facets[t] : candidates_.mirrors[t];
  }
  // From one side, so that the other one is the back.
  bool is_kept(std::uint32_t t) const {
    return states_[2 * t] == HalfState::kept || states_[2 * t] == HalfState::kept_from_back;
  }
  const Triangle& corners(Half h) const { return candidates_.corners[triangle_of_half(h)]; }

  // --- where to begin

  // Infinite cells come last: seen from outside is seen from the cell behind.
  std::vector<Half> hull_starts() const {
    std::vector<Half> starts;
    for (std::uint32_t t = 0; t < candidates_.size(); ++t) {
      const CellId behind = cell_of(candidates_.mirrors[t]);
      if (triangulation_.is_infinite(behind) && may_start(2 * t + 1)) starts.push_back(2 * t + 1);
    }
    return starts;
  }

  // Each facet once, seen from its positive side, or from the other one if that is the inside of a
  // flat tetrahedron all of whose facets are candidates.
  std::vector<Half> other_starts() const {
    std::vector<Half> starts;
    for (std::uint32_t t = 0; t < candidates_.size(); ++t) {
      if (!may_start(2 * t)) continue;
      const Half positive = sees_positive_side(2 * t) ? 2 * t : 2 * t + 1;
      const bool inside_flat = candidates_.set.bits(cell_of(facet_of(positive))) == 15;
      starts.push_back(inside_flat ? other_half(positive) : positive);
    }
    return starts;
  }

  bool may_start(Half h) const {
    if (states_[h] != HalfState::open) return false;
    for (const VertexId v : corners(h)) {
      if (umbrella_[v] == 0 || on_surface_[v] != 0) return false;
    }
    return true;
  }

  struct Start {
    Point lowest;  // corner; decides nearly always
    Half half;
  };

  // In the order of their sorted corners.
  void walk_from(const std::vector<Half>& halves) {
    if (halves.empty()) return;
    std::vector<Start> starts;
    starts.reserve(halves.size());
    for (const Half h : halves) starts.push_back({lowest_corner(h), h});
    const auto earlier = [&](const Start& a, const Start& b) {
      if (a.lowest != b.lowest) return a.lowest < b.lowest;
      return sorted_corners(triangulation_, facet_of(a.half)) <
             sorted_corners(triangulation_, facet_of(b.half));
    };
    // Nearly always the first walk covers all: sort only what it leaves.
    walk(std::min_element(starts.begin(), starts.end(), earlier)->half);
    std::erase_if(starts, [&](const Start& start) { return !may_start(start.half); });
    std::sort(starts.begin(), starts.end(), earlier);
    for (const Start& start : starts) {
      if (may_start(start.half)) walk(start.half);
    }
  }

  // --- the walk

  // A half-facet and the side of its triangle over which the walk came.
  struct Arrival {
    Half half;
    SideId side;
  };

  void walk(Half start) {
    ++walks_;
    keep(start);
    std::vector<Arrival> frontier{{start, no_side}};
    std::vector<Arrival> kept;
    std::vector<Half> dropped;
    while (!frontier.empty()) {
      for (const Arrival& arrival : frontier) turn_about_edges(arrival, kept, dropped);
      std::erase_if(kept, [&](const Arrival& arrival) { return !is_accepted(arrival.half); });
      for (const Arrival& arrival : kept) keep(arrival.half);
      for (const Half h : dropped) {
        if (states_[h] == HalfState::open) drop(h);
      }
      std::swap(frontier, kept);
      kept.clear();
      dropped.clear();
    }
  }

  void turn_about_edges(const Arrival& arrival, std::vector<Arrival>& kept,
                        std::vector<Half>& dropped) {
    const SideId first = 3 * triangle_of_half(arrival.half);
    for (SideId side = first; side < first + 3; ++side) {
      if (side == arrival.side) continue;
      const auto [a, b] = candidates_.ends(side);
      if (umbrella_[a] == 0 && umbrella_[b] == 0) continue;
      if (candidates_.is_two_sided(side)) {
        const SideId met = candidates_.links[side];
        if (states_[facing_half(arrival.half, side, met)] != HalfState::dropped) {
          meet_first(facing_half(arrival.half, side, met), met, kept);
        }
      } else if (candidates_.links[side] != side) {
        turn(arrival.half, side, kept, dropped);
      }
    }
  }

  // Of the triangle of `other`, the half on the walker's side when he comes from `half` over their
  // edge: seen from one side, the triangles run through it in opposite directions.
  Half facing_half(Half half, SideId side, SideId other) const {
    const bool opposite = candidates_.ends(side)[0] != candidates_.ends(other)[0];
    return 2 * triangle_of_side(other) + (opposite ? half & 1U : (half & 1U) ^ 1U);
  }

  void meet_first(Half met, SideId side, std::vector<Arrival>& kept) {
    HalfState& state = states_[met];
    if (state == HalfState::open) {
      state = HalfState::proposed;
      kept.push_back({met, side});
    } else if (state == HalfState::kept_from_back) {
      ++back_contacts_;
    }
  }

  // Once around an edge with more than two candidates, beginning on the side of the half-facet.
  void turn(Half half, SideId side, std::vector<Arrival>& kept, std::vector<Half>& dropped) {
    FacetId f = facet_of(half);
    const FacetId back = triangulation_.mirror(f);
    VertexId third = candidates_.corners[triangle_of_side(side)][corner_of_side(side)];
    bool first = true;
    for (;;) {
      const FacetId g =
          facet_id(cell_of(f), index_of_vertex(triangulation_.cell(cell_of(f)), third));
      if (g == back) return;
      const SideId met_side = side_of_facet(side, g);
      if (met_side != no_side) {
        const Half met = facing_half(half, side, met_side);
        if (states_[met] != HalfState::dropped) {
          if (first) {
            meet_first(met, met_side, kept);
          } else if (states_[met] == HalfState::open) {
            dropped.push_back(met);
          }
          first = false;
        }
      }
      third = triangulation_.opposite_vertex(f);
      f = triangulation_.mirror(g);
    }
  }

  // The side of facet g at the edge of `side`, if g is a candidate.
  SideId side_of_facet(SideId side, FacetId g) const {
    if (!candidates_.set.contains(g)) return no_side;
    const FacetId canonical = triangulation_.canonical(g);
    SideId found = no_side;
    for_each_side_at_edge(candidates_, side, [&](SideId other) {
      if (candidates_.facets[triangle_of_side(other)] == canonical) found = other;
    });
    return found;
  }

  // Of the two sides from which one round may propose a facet the positive one is taken.
  bool is_accepted(Half h) const {
    return states_[other_half(h)] != HalfState::proposed || sees_positive_side(h);
  }

  void keep(Half h) {
    states_[h] = HalfState::kept;
    states_[other_half(h)] = HalfState::kept_from_back;
    for (const VertexId v : corners(h)) on_surface_[v] = 1;
  }

  void drop(Half h) {
    states_[h] = HalfState::dropped;
    states_[other_half(h)] = HalfState::dropped;
  }

  // Candidates that no walk reached and that share no vertex with one.
  void keep_unwalked() {
    std::vector<Half> apart;
    for (std::uint32_t t = 0; t < candidates_.size(); ++t) {
      if (states_[2 * t] != HalfState::open) continue;
      const auto [a, b, c] = candidates_.corners[t];
      if ((on_surface_[a] | on_surface_[b] | on_surface_[c]) != 0) continue;
      apart.push_back(sees_positive_side(2 * t) ? 2 * t : 2 * t + 1);
    }
    for (const Half h : apart) keep(h);
    unwalked_ = apart.size();
  }

  // --- canonical choices

  Point lowest_corner(Half h) const {
    const auto [a, b, c] = corners(h);
    return std::min({triangulation_.point(a), triangulation_.point(b), triangulation_.point(c)});
  }

  // Does the half-facet lie on the side to which the normal of its sorted corners points?
  bool sees_positive_side(Half h) const {
    Triangle v = corners(h);  // normal away from the side
    if ((h & 1U) != 0) std::swap(v[1], v[2]);
    const auto less = [&](VertexId a, VertexId b) {
      return triangulation_.point(a) < triangulation_.point(b);
    };
    std::rotate(v.begin(), std::min_element(v.begin(), v.end(), less), v.end());
    return less(v[2], v[1]);
  }

  static constexpr SideId no_side = 0xFFFFFFFFU;
  const Triangulation& triangulation_;
  const LinkedFacets& candidates_;
  const VertexSet& umbrella_;
  std::vector<HalfState> states_;  // per half
  VertexSet on_surface_;
  std::size_t walks_ = 0;
  std::size_t unwalked_ = 0;
  std::size_t back_contacts_ = 0;
};

}  // namespace

ManifoldSurface extract_manifold(const Triangulation& triangulation, LinkedFacets candidates,
                                 const VertexSet& umbrella, const Execution& execution) {
  report_progress(execution, "extract_manifold", 0);
  ManifoldSurface surface;
  std::vector<std::uint8_t> off_surface;
  {
    Walk walk(triangulation, candidates, umbrella);
    walk.run();
    surface.halves = walk.halves();
    surface.walks = walk.walks();
    surface.unwalked = walk.unwalked();
    surface.back_contacts = walk.back_contacts();
    off_surface = walk.off_surface();
  }
  surface.triangles = without(triangulation, std::move(candidates), off_surface);
  for (const auto& [from, to] : moves_into_places(off_surface)) {
    surface.halves[to] = surface.halves[from];
  }
  surface.dropped = surface.halves.size() - surface.triangles.size();
  surface.halves.resize(surface.triangles.size());
  report_progress(execution, "extract_manifold", 1);
  return surface;
}

}  // namespace cocoon
