#include "cocone/extract_manifold.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>

#include "cocone/facets/cell_order.h"
#include "cocone/facets/facet_size.h"
#include "cocone/facets/half_facets.h"
#include "cocone/facets/walk_reach.h"
#include "cocone/inputs/stage_inputs.h"

namespace cocoon {
namespace {

constexpr std::size_t triangles_per_chunk = std::size_t{1} << 14;

class Walk {
 public:
  Walk(const Triangulation& triangulation, const LinkedFacets& candidates,
       const VertexSet& umbrella, FirstWalk first_walk, const Execution& execution)
      : triangulation_(triangulation),
        candidates_(candidates),
        umbrella_(umbrella),
        execution_(execution),
        first_walk_(first_walk),
        states_(candidates.size(), walk_state::open),
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
    parallel_chunks(execution_, halves.size(), triangles_per_chunk,
                    [&](std::size_t begin, std::size_t end) {
                      for (std::size_t t = begin; t < end; ++t) {
                        const FacetId front = candidates_.facets[t];
                        const FacetId back = candidates_.mirrors[t];
                        halves[t] = states_[t] == walk_state::kept[0] ? front : back;
                      }
                    });
    return halves;
  }
  std::vector<std::uint8_t> off_surface() && {
    for (std::uint8_t& state : states_) state = is_kept(state) ? 0 : 1;
    return std::move(states_);
  }
  FirstWalk first_walk() const { return first_walk_; }
  std::size_t walks() const { return walks_; }
  std::size_t unwalked() const { return unwalked_; }
  std::size_t back_contacts() const { return back_contacts_; }

 private:
  static bool is_kept(std::uint8_t state) {
    return state == walk_state::kept[0] || state == walk_state::kept[1];
  }
  FacetId facet_of(Half h) const { return facet_of_half(candidates_, h); }
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

  // Each facet once, seen from its wider side, or from the other one if that is the inside of a
  // flat tetrahedron. From the inside of two of them one would keep what belongs to no sheet.
  std::vector<Half> other_starts() const {
    std::vector<Half> starts;
    for (std::uint32_t t = 0; t < candidates_.size(); ++t) {
      if (!may_start(2 * t)) continue;
      const Half wide = wider_half(t);
      const Half from = is_inside_flat(wide) ? other_half(wide) : wide;
      if (!is_inside_flat(from)) starts.push_back(from);
    }
    return starts;
  }

  // All facets of the cell are candidates.
  bool is_inside_flat(Half h) const { return candidates_.set.bits(cell_of(facet_of(h))) == 15; }

  bool may_start(Half h) const {
    if (states_[triangle_of_half(h)] != walk_state::open) return false;
    for (const VertexId v : corners(h)) {
      if (umbrella_[v] == 0 || on_surface_[v] != 0) return false;
    }
    return true;
  }

  // By the size of their facets.
  void walk_from(std::vector<Half> halves) {
    if (halves.empty()) return;
    // Nearly always the first walk covers all: sort only what it leaves.
    const Half first = smallest(halves);
    const bool may_reach = walks_ == 0 && first_walk_ == FirstWalk::at_once;
    if (!may_reach || !reach_from(first)) walk(first);
    std::erase_if(halves, [&](Half h) { return !may_start(h); });
    std::vector<std::pair<FacetSize, Half>> starts;
    starts.reserve(halves.size());
    for (const Half h : halves) starts.emplace_back(size_of(h), h);
    std::sort(starts.begin(), starts.end(),
              [](const auto& a, const auto& b) { return a.first < b.first; });
    for (const auto& [size, half] : starts) {
      if (may_start(half)) walk(half);
    }
  }

  // No circle is narrower than a side of its triangle is long: most need not be measured.
  Half smallest(const std::vector<Half>& halves) const {
    constexpr double more_than_rounding = 1 + 1e-9;
    Half best = halves.front();
    FacetSize least = size_of(best);
    for (const Half h : halves) {
      const double squared_diameter = 4 * least.squared_circumradius;
      if (squared_longest_side(h) > more_than_rounding * squared_diameter) continue;
      const FacetSize size = size_of(h);
      if (!(size < least)) continue;
      least = size;
      best = h;
    }
    return best;
  }

  // --- the walk

  // The first walk, if it goes without rounds.
  bool reach_from(Half start) {
    std::optional<std::vector<std::uint8_t>> states =
        walk_reach(triangulation_, candidates_, umbrella_, start, execution_);
    if (!states) {
      first_walk_ = FirstWalk::in_rounds;
      return false;
    }
    ++walks_;
    states_ = std::move(*states);
    if (std::find(states_.begin(), states_.end(), walk_state::open) == states_.end()) return true;
    for (std::size_t t = 0; t < candidates_.size(); ++t) {
      if (!is_kept(states_[t])) continue;
      for (const VertexId v : candidates_.corners[t]) on_surface_[v] = 1;
    }
    return true;
  }

  // A half-facet and the halfedge of its triangle over which the walk came.
  struct Arrival {
    Half half;
    Halfedge halfedge;
  };

  void walk(Half start) {
    ++walks_;
    keep(start);
    std::vector<Arrival> frontier{{start, no_halfedge}};
    std::vector<Arrival> kept;
    std::vector<Half> dropped;
    while (!frontier.empty()) {
      for (const Arrival& arrival : frontier) turn_about_edges(arrival, kept, dropped);
      std::erase_if(kept, [&](const Arrival& arrival) { return !is_accepted(arrival.half); });
      for (const Arrival& arrival : kept) keep(arrival.half);
      for (const Half h : dropped) {
        std::uint8_t& state = states_[triangle_of_half(h)];
        if (state == walk_state::open) state = walk_state::dropped;
      }
      std::swap(frontier, kept);
      kept.clear();
      dropped.clear();
    }
  }

  void turn_about_edges(const Arrival& arrival, std::vector<Arrival>& kept,
                        std::vector<Half>& dropped) {
    const Halfedge first = 3 * triangle_of_half(arrival.half);
    for (Halfedge halfedge = first; halfedge < first + 3; ++halfedge) {
      if (halfedge == arrival.halfedge || !is_crossed(candidates_, umbrella_, halfedge)) continue;
      if (candidates_.has_two_triangles(halfedge)) {
        const Halfedge met = candidates_.links[halfedge];
        const Half half = facing_half(candidates_, arrival.half, halfedge, met);
        if (!is_dropped(half)) meet_first(half, met, kept);
      } else {
        turn(arrival.half, halfedge, kept, dropped);
      }
    }
  }

  bool is_dropped(Half h) const { return states_[triangle_of_half(h)] == walk_state::dropped; }

  void meet_first(Half met, Halfedge halfedge, std::vector<Arrival>& kept) {
    std::uint8_t& state = states_[triangle_of_half(met)];
    if (state == walk_state::kept[other_half(met) & 1U]) {
      ++back_contacts_;
    } else if (may_be_proposed(state, met)) {
      state |= walk_state::proposed[met & 1U];
      kept.push_back({met, halfedge});
    }
  }
  // A round may still propose it from the other side.
  static bool may_be_proposed(std::uint8_t state, Half h) {
    return state == walk_state::open || state == walk_state::proposed[other_half(h) & 1U];
  }

  // Once around an edge with more than two candidates.
  void turn(Half half, Halfedge halfedge, std::vector<Arrival>& kept, std::vector<Half>& dropped) {
    bool first = true;
    turn_about_edge(triangulation_, candidates_, half, halfedge,
                    [&](Half met, Halfedge met_halfedge) {
                      if (is_dropped(met)) return;
                      if (first) {
                        meet_first(met, met_halfedge, kept);
                      } else if (may_be_proposed(states_[triangle_of_half(met)], met)) {
                        dropped.push_back(met);
                      }
                      first = false;
                    });
  }

  // Of the two sides from which one round may propose a facet the wider one is taken.
  bool is_accepted(Half h) const {
    const std::uint8_t from_back = walk_state::proposed[other_half(h) & 1U];
    return (states_[triangle_of_half(h)] & from_back) == 0 || wider_half(triangle_of_half(h)) == h;
  }

  void keep(Half h) {
    states_[triangle_of_half(h)] = walk_state::kept[h & 1U];
    for (const VertexId v : corners(h)) on_surface_[v] = 1;
  }

  // Candidates that no walk reached and that share no vertex with one.
  void keep_unwalked() {
    std::vector<Half> apart;
    for (std::uint32_t t = 0; t < candidates_.size(); ++t) {
      if (states_[t] != walk_state::open) continue;
      const auto [a, b, c] = candidates_.corners[t];
      if ((on_surface_[a] | on_surface_[b] | on_surface_[c]) != 0) continue;
      apart.push_back(wider_half(t));
    }
    for (const Half h : apart) keep(h);
    unwalked_ = apart.size();
  }

  // --- canonical choices

  FacetSize size_of(Half h) const { return size_of_facet(triangulation_, facet_of(h)); }

  double squared_longest_side(Half h) const {
    const auto [a, b, c] = corners(h);
    const Point& p = triangulation_.point(a);
    const Point& q = triangulation_.point(b);
    const Point& r = triangulation_.point(c);
    return std::max({squared_distance(p, q), squared_distance(q, r), squared_distance(r, p)});
  }

  // The half of a triangle with more space before it; of equal ones the positive one.
  Half wider_half(std::uint32_t t) const {
    const double front = reach_before(2 * t);
    const double back = reach_before(2 * t + 1);
    if (front != back) return front > back ? 2 * t : 2 * t + 1;
    return sees_positive_side(2 * t) ? 2 * t : 2 * t + 1;
  }

  // How far the cell on the side of the half-facet reaches away from the corners: the sum of their
  // squared distances from its fourth vertex.
  double reach_before(Half h) const {
    const FacetId f = facet_of(h);
    const VertexId ahead = triangulation_.opposite_vertex(f);
    if (ahead == infinite_vertex) return std::numeric_limits<double>::infinity();
    double sum = 0;
    for (const Point& p : sorted_corners(triangulation_, f)) {
      sum += squared_distance(p, triangulation_.point(ahead));
    }
    return sum;
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

  const Triangulation& triangulation_;
  const LinkedFacets& candidates_;
  const VertexSet& umbrella_;
  const Execution& execution_;
  FirstWalk first_walk_;
  std::vector<std::uint8_t> states_;  // per triangle
  VertexSet on_surface_;
  std::size_t walks_ = 0;
  std::size_t unwalked_ = 0;
  std::size_t back_contacts_ = 0;
};

// `keep_rest`: surface.rest is wanted.
ManifoldSurface extract(const Triangulation& triangulation, LinkedFacets candidates,
                        const VertexSet& umbrella, FirstWalk first_walk, bool keep_rest,
                        const Execution& execution) {
  require_facets("extract_manifold", triangulation, candidates);
  require_vertex_flags("extract_manifold", triangulation, umbrella);
  report_progress(execution, "extract_manifold", 0);
  ManifoldSurface surface;
  std::vector<std::uint8_t> off_surface;
  {
    Walk walk(triangulation, candidates, umbrella, first_walk, execution);
    walk.run();
    surface.first_walk = walk.first_walk();
    surface.halves = walk.halves();
    surface.walks = walk.walks();
    surface.unwalked = walk.unwalked();
    surface.back_contacts = walk.back_contacts();
    off_surface = std::move(walk).off_surface();
  }
  surface.triangles = without(triangulation, std::move(candidates), off_surface,
                              keep_rest ? &surface.rest : nullptr);
  for (const auto& [from, to] : moves_into_places(off_surface)) {
    surface.halves[to] = surface.halves[from];
  }
  surface.halves.resize(surface.triangles.size());
  report_progress(execution, "extract_manifold", 1);
  return surface;
}

}  // namespace

ManifoldSurface extract_manifold(const Triangulation& triangulation, LinkedFacets candidates,
                                 const VertexSet& umbrella, const Execution& execution) {
  return extract(triangulation, std::move(candidates), umbrella, FirstWalk::at_once, false,
                 execution);
}

ManifoldSurface extract_again(const Triangulation& triangulation, LinkedFacets candidates,
                              const VertexSet& umbrella, FirstWalk first_walk,
                              const Execution& execution) {
  return extract(triangulation, std::move(candidates), umbrella, first_walk, true, execution);
}

}  // namespace cocoon
