#include "cocone/extract_manifold.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

#include "delaunay/circulate.h"

namespace cocoon {
namespace {

using Corners = std::array<Point, 3>;

// What is known of a facet, from one of its sides.
enum class HalfState : std::uint8_t {
  none,  // not a candidate
  open,
  proposed,
  kept,
  kept_from_back,
  dropped
};

class Walk {
 public:
  Walk(const Triangulation& triangulation, const FacetSet& candidates, const VertexSet& umbrella)
      : triangulation_(triangulation),
        candidates_(candidates),
        umbrella_(umbrella),
        states_(4 * triangulation.num_cells(), HalfState::none),
        on_surface_(triangulation.num_vertices(), 0) {
    for (const CellId c : triangulation.cells()) {
      if (candidates.bits(c) == 0) continue;
      for (int i = 0; i < 4; ++i) {
        const FacetId f = facet_id(c, i);
        if (!candidates.contains(f)) continue;
        states_[f] = HalfState::open;
        ++num_halves_;
      }
    }
  }

  ManifoldSurface run() {
    walk_from(hull_starts());
    walk_from(other_starts());
    keep_unwalked();
    result_.facets = FacetSet(triangulation_.num_cells());
    for (const FacetId f : result_.halves) result_.facets.insert(triangulation_, f);
    result_.dropped = num_halves_ / 2 - result_.halves.size();
    std::sort(result_.halves.begin(), result_.halves.end());
    return std::move(result_);
  }

 private:
  HalfState& state(FacetId f) { return states_[f]; }

  // --- where to begin

  std::vector<FacetId> hull_starts() {
    std::vector<FacetId> starts;
    for (const CellId c : triangulation_.infinite_cells()) {
      const FacetId f = facet_id(c, 3);
      if (candidates_.contains(f) && may_start(f)) starts.push_back(f);
    }
    return starts;
  }

  // Each facet once, seen from its positive side, or from the other one if that is the inside of a
  // flat tetrahedron all of whose facets are candidates.
  std::vector<FacetId> other_starts() {
    std::vector<FacetId> starts;
    candidates_.for_each(triangulation_, [&](FacetId f) {
      if (!may_start(f)) return;
      const FacetId mirror = triangulation_.mirror(f);
      const FacetId positive = sees_positive_side(f) ? f : mirror;
      const bool inside_flat = candidates_.bits(cell_of(positive)) == 15;
      starts.push_back(inside_flat ? triangulation_.mirror(positive) : positive);
    });
    return starts;
  }

  bool may_start(FacetId f) {
    if (state(f) != HalfState::open) return false;
    for (const VertexId v : triangulation_.facet_vertices(f)) {
      if (umbrella_[v] == 0 || on_surface_[v] != 0) return false;
    }
    return true;
  }

  void walk_from(std::vector<FacetId> starts) {
    const auto smaller = [&](FacetId a, FacetId b) {
      return sorted_corners(a) < sorted_corners(b);
    };
    if (starts.empty()) return;
    // Nearly always the first walk covers all: sort only what it leaves.
    walk(*std::min_element(starts.begin(), starts.end(), smaller));
    std::erase_if(starts, [&](FacetId f) { return !may_start(f); });
    std::sort(starts.begin(), starts.end(), smaller);
    for (const FacetId f : starts) {
      if (may_start(f)) walk(f);
    }
  }

  // --- the walk

  // A kept facet, and the edge (by its opposite vertex) over which the walk came.
  struct Arrival {
    FacetId facet;
    VertexId apex;
  };

  void walk(FacetId start) {
    ++result_.walks;
    keep(start);
    std::vector<Arrival> frontier{{start, VertexId{}}};
    std::vector<Arrival> kept;
    std::vector<FacetId> dropped;
    while (!frontier.empty()) {
      for (std::size_t i = 0; i < frontier.size(); ++i) {
        fetch_ahead(frontier, i);
        turn_about_edges(frontier[i], kept, dropped);
      }
      std::erase_if(kept, [&](const Arrival& arrival) { return !is_accepted(arrival.facet); });
      for (const Arrival& arrival : kept) keep(arrival.facet);
      for (const FacetId f : dropped) {
        if (state(f) == HalfState::open) drop(f);
      }
      std::swap(frontier, kept);
      kept.clear();
      dropped.clear();
    }
  }

  // A round goes all over the memory: asks for the cells that it soon turns through, those next to
  // the two cells of a facet, as soon as these should have come.
  void fetch_ahead(const std::vector<Arrival>& frontier, std::size_t i) const {
    constexpr std::size_t ahead = 8;
    const auto fetch = [&](CellId c) { __builtin_prefetch(&triangulation_.cell(c)); };
    if (i + 3 * ahead < frontier.size()) fetch(cell_of(frontier[i + 3 * ahead].facet));
    if (i + 2 * ahead < frontier.size()) {
      for (const FacetId f : triangulation_.cell(cell_of(frontier[i + 2 * ahead].facet)).neighbors)
        fetch(cell_of(f));
    }
    if (i + ahead < frontier.size()) {
      const CellId back = cell_of(triangulation_.mirror(frontier[i + ahead].facet));
      for (const FacetId f : triangulation_.cell(back).neighbors) fetch(cell_of(f));
    }
  }

  void turn_about_edges(const Arrival& arrival, std::vector<Arrival>& kept,
                        std::vector<FacetId>& dropped) {
    const std::array<VertexId, 3> v = triangulation_.facet_vertices(arrival.facet);
    for (std::size_t i = 0; i < 3; ++i) {
      if (v[i] == arrival.apex) continue;
      if (umbrella_[v[(i + 1) % 3]] == 0 && umbrella_[v[(i + 2) % 3]] == 0) continue;
      turn(arrival.facet, v[i], kept, dropped);
    }
  }

  // Once around the edge of f opposite `third`, beginning on f's side.
  void turn(FacetId f, VertexId third, std::vector<Arrival>& kept, std::vector<FacetId>& dropped) {
    const FacetId back = triangulation_.mirror(f);
    bool first = true;
    for (;;) {
      const FacetId g =
          facet_id(cell_of(f), index_of_vertex(triangulation_.cell(cell_of(f)), third));
      const VertexId apex = triangulation_.opposite_vertex(f);
      if (g == back) return;
      HalfState& met = state(g);
      if (met != HalfState::none && met != HalfState::dropped) {
        if (!first) {
          if (met == HalfState::open) dropped.push_back(g);
        } else if (met == HalfState::open) {
          met = HalfState::proposed;
          kept.push_back({g, apex});
        } else if (met == HalfState::kept_from_back) {
          ++result_.back_contacts;
        }
        first = false;
      }
      third = apex;
      f = triangulation_.mirror(g);
    }
  }

  // Of the two sides from which one round may propose a facet the positive one is taken.
  bool is_accepted(FacetId f) {
    const bool both = state(triangulation_.mirror(f)) == HalfState::proposed;
    return !both || sees_positive_side(f);
  }

  void keep(FacetId f) {
    state(f) = HalfState::kept;
    state(triangulation_.mirror(f)) = HalfState::kept_from_back;
    result_.halves.push_back(f);
    for (const VertexId v : triangulation_.facet_vertices(f)) on_surface_[v] = 1;
  }

  void drop(FacetId f) {
    state(f) = HalfState::dropped;
    state(triangulation_.mirror(f)) = HalfState::dropped;
  }

  // Candidates that no walk reached and that share no vertex with one.
  void keep_unwalked() {
    std::vector<FacetId> apart;
    candidates_.for_each(triangulation_, [&](FacetId f) {
      if (state(f) != HalfState::open) return;
      const auto [a, b, c] = triangulation_.facet_vertices(f);
      if ((on_surface_[a] | on_surface_[b] | on_surface_[c]) != 0) return;
      apart.push_back(sees_positive_side(f) ? f : triangulation_.mirror(f));
    });
    for (const FacetId f : apart) keep(f);
    result_.unwalked = apart.size();
  }

  // --- canonical choices

  Corners sorted_corners(FacetId f) const {
    const auto [a, b, c] = triangulation_.facet_vertices(f);
    Corners corners{triangulation_.point(a), triangulation_.point(b), triangulation_.point(c)};
    std::sort(corners.begin(), corners.end());
    return corners;
  }

  // Does the half-facet lie on the side to which the normal of its sorted corners points?
  bool sees_positive_side(FacetId f) const {
    std::array<VertexId, 3> v = triangulation_.facet_vertices(f);  // normal away from the side
    const auto less = [&](VertexId a, VertexId b) {
      return triangulation_.point(a) < triangulation_.point(b);
    };
    std::rotate(v.begin(), std::min_element(v.begin(), v.end(), less), v.end());
    return less(v[2], v[1]);
  }

  const Triangulation& triangulation_;
  const FacetSet& candidates_;
  const VertexSet& umbrella_;
  IdVector<FacetId, HalfState> states_;  // per half-facet
  std::size_t num_halves_ = 0;           // of candidates
  VertexSet on_surface_;
  ManifoldSurface result_;
};

}  // namespace

ManifoldSurface extract_manifold(const Triangulation& triangulation, const FacetSet& candidates,
                                 const VertexSet& umbrella, const Execution& execution) {
  report_progress(execution, "extract_manifold", 0);
  ManifoldSurface surface = Walk(triangulation, candidates, umbrella).run();
  report_progress(execution, "extract_manifold", 1);
  return surface;
}

}  // namespace cocoon
