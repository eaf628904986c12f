#include "cocone/boundary_samples.h"

#include <cmath>
#include <vector>

namespace cocoon {
namespace {

constexpr std::size_t vertices_per_chunk = 4096;

enum class State : std::uint8_t {
  ratio_fails,  // boundary for good
  pending,      // only the normal condition fails: phase 2 may still take it in
  interior,
};

struct Conditions {
  const Triangulation& triangulation;
  const VertexStars& stars;
  const Poles& poles;
  const Cocones& cocones;
  double alpha_cosine;

  bool normals_agree(VertexId p, VertexId q) const {
    return std::abs(dot(poles.normals[p], poles.normals[q])) >= alpha_cosine;
  }

  // Calls visit(p, q, p_in_N_q, q_in_N_p) for facets that contain p and another vertex q, until it
  // returns false. A pair may come up several times. Returns false if it was stopped.
  template <class Visit>
  bool for_each_neighbor(VertexId p, Visit visit) const {
    for (const CellId c : stars.star(p)) {
      const unsigned meets = cocones.meets[c];
      if (meets == 0) continue;
      const Cell& cell = triangulation.cell(c);
      int corner = 0;
      while (cell.vertices[static_cast<std::size_t>(corner)] != p) ++corner;
      for (int i = 0; i < 4; ++i) {
        const unsigned row = (meets >> (4 * i)) & 15U;
        // Each facet at p shows in two cells of the star: the one with the smaller id tells of it.
        if (i == corner || row == 0 || triangulation.mirror(facet_id(c, i)) < facet_id(c, i)) {
          continue;
        }
        for (int k = 0; k < 4; ++k) {
          if (k == i || k == corner) continue;
          const VertexId q = cell.vertices[static_cast<std::size_t>(k)];
          if (!visit(q, ((row >> k) & 1U) != 0, ((row >> corner) & 1U) != 0)) return false;
        }
      }
    }
    return true;
  }

  bool normal_condition(VertexId p) const {
    return for_each_neighbor(p, [&](VertexId q, bool p_is_neighbor_of_q, bool) {
      return !p_is_neighbor_of_q || normals_agree(p, q);
    });
  }

  bool joins(VertexId p, const IdVector<VertexId, State>& states) const {
    return !for_each_neighbor(p, [&](VertexId q, bool p_is_neighbor_of_q, bool) {
      return !(p_is_neighbor_of_q && states[q] == State::interior && normals_agree(p, q));
    });
  }
};

// Phase 2: the least fixed point, from the pending samples outward.
std::size_t recover_pending(const Conditions& conditions, IdVector<VertexId, State>& states) {
  std::vector<VertexId> joined;
  for (const VertexId p : states.ids()) {
    if (states[p] == State::pending && conditions.joins(p, states)) joined.push_back(p);
  }
  for (const VertexId p : joined) states[p] = State::interior;
  for (std::size_t next = 0; next < joined.size(); ++next) {
    const VertexId q = joined[next];
    conditions.for_each_neighbor(q, [&](VertexId p, bool, bool p_is_neighbor_of_q) {
      if (p_is_neighbor_of_q && states[p] == State::pending && conditions.normals_agree(p, q)) {
        states[p] = State::interior;
        joined.push_back(p);
      }
      return true;
    });
  }
  return joined.size();
}

}  // namespace

BoundarySamples boundary_samples(const Triangulation& triangulation, const Dual& dual,
                                 const VertexStars& stars, const Poles& poles,
                                 const Cocones& cocones, const BoundaryOptions& options,
                                 const Execution& execution) {
  report_progress(execution, "boundary_samples", 0);
  const std::size_t count = triangulation.num_vertices();
  const Conditions conditions{triangulation, stars, poles, cocones, options.alpha_cosine};
  // phase 1
  IdVector<VertexId, State> states(count, State::ratio_fails);
  parallel_chunks(execution, count, vertices_per_chunk, [&](std::size_t begin, std::size_t end) {
    for (VertexId p(begin); p.index() < end; ++p) {
      // The cells of a star lie here and there in memory: ask for those of the next ones.
      constexpr std::size_t ahead = 2;
      if (p.index() + ahead < end) {
        for (const CellId c : stars.star(VertexId(p.index() + ahead))) {
          __builtin_prefetch(&cocones.meets[c]);
          __builtin_prefetch(&triangulation.cell(c));
        }
      }
      if (poles.degenerate[p] != 0) continue;
      const double radius =
          cocone_radius(triangulation, dual, stars, poles, cocones, p, options.radius_mode);
      if (!(radius <= options.rho * poles.heights[p])) continue;
      states[p] = conditions.normal_condition(p) ? State::interior : State::pending;
    }
  });
  report_progress(execution, "boundary_samples", 0.8);
  // phase 2
  BoundarySamples result;
  result.recovered = recover_pending(conditions, states);
  result.boundary = VertexSet(count, 0);
  for (const VertexId p : states.ids()) {
    result.boundary[p] = states[p] != State::interior;
    result.count += result.boundary[p];
    result.ratio_failed += states[p] == State::ratio_fails;
  }
  report_progress(execution, "boundary_samples", 1);
  return result;
}

}  // namespace cocoon
