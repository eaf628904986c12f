#include "cocone/boundary_samples.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "cocone/cocone_radii.h"
#include "cocone/shared_flags.h"

namespace cocoon {
namespace {

constexpr std::size_t facets_per_chunk = 8192;

// p is a cocone neighbor of q: p in N_q.
struct NeighborOf {
  VertexId q;
  VertexId p;
  friend auto operator<=>(const NeighborOf&, const NeighborOf&) = default;
};

struct Conditions {
  const Triangulation& triangulation;
  const Poles& poles;
  const Cocones& cocones;
  double alpha_cosine;

  bool normals_agree(VertexId p, VertexId q) const {
    return std::abs(dot(poles.normals[p], poles.normals[q])) >= alpha_cosine;
  }

  // Calls visit(p, q) for p in N_q as the facets begin .. end of `cocones` tell it; a pair may come
  // up for several facets.
  template <class Visit>
  void for_each_neighbor(std::size_t begin, std::size_t end, Visit visit) const {
    for (std::size_t k = begin; k < end; ++k) {
      const FacetId f = cocones.facets[k];
      const unsigned row = cocones.rows[k];
      const Cell& cell = triangulation.cell(cell_of(f));
      const int* corners = facet_corners[index_of(f)];
      for (int i = 0; i < 3; ++i) {
        if (((row >> corners[i]) & 1U) == 0) continue;
        const VertexId q = cell.vertices[static_cast<std::size_t>(corners[i])];
        visit(cell.vertices[static_cast<std::size_t>(corners[(i + 1) % 3])], q);
        visit(cell.vertices[static_cast<std::size_t>(corners[(i + 2) % 3])], q);
      }
    }
  }
};

// Raised: the normal condition fails.
SharedFlags failing_normals(const Conditions& conditions, const Execution& execution) {
  SharedFlags fails(conditions.triangulation.num_vertices());
  parallel_chunks(execution, conditions.cocones.facets.size(), facets_per_chunk,
                  [&](std::size_t begin, std::size_t end) {
                    conditions.for_each_neighbor(begin, end, [&](VertexId p, VertexId q) {
                      if (!conditions.normals_agree(p, q)) fails.raise(p);
                    });
                  });
  return fails;
}

using State = SampleState;

// Phase 2: the least fixed point, from the interior samples outward along p in N_q with agreeing
// normals and p pending.
std::size_t recover_pending(const Conditions& conditions, IdVector<VertexId, State>& states) {
  std::vector<NeighborOf> steps;
  conditions.for_each_neighbor(0, conditions.cocones.facets.size(), [&](VertexId p, VertexId q) {
    if (states[p] != State::pending || states[q] == State::ratio_fails) return;
    if (conditions.normals_agree(p, q)) steps.push_back({q, p});
  });
  std::vector<VertexId> joined;
  const auto take = [&](VertexId p) {
    if (states[p] != State::pending) return;
    states[p] = State::interior;
    joined.push_back(p);
  };
  const auto from_interior = [&](const NeighborOf& step) {
    return states[step.q] == State::interior;
  };
  const auto first_joining = std::partition(steps.begin(), steps.end(), from_interior);
  for (auto step = steps.begin(); step != first_joining; ++step) take(step->p);
  std::sort(first_joining, steps.end());
  for (std::size_t next = 0; next < joined.size(); ++next) {
    const VertexId q = joined[next];
    auto step = std::lower_bound(first_joining, steps.end(), NeighborOf{q, VertexId(0)});
    for (; step != steps.end() && step->q == q; ++step) take(step->p);
  }
  return joined.size();
}

}  // namespace

IdVector<VertexId, SampleState> judge_samples(const Triangulation& triangulation, const Dual& dual,
                                              const Poles& poles, const Cocones& cocones,
                                              const BoundaryOptions& options,
                                              const Execution& execution) {
  const Conditions conditions{triangulation, poles, cocones, options.alpha_cosine};
  const IdVector<VertexId, double> radii =
      cocone_radii(triangulation, dual, poles, cocones, options.radius_mode, execution);
  const SharedFlags normal_fails = failing_normals(conditions, execution);
  IdVector<VertexId, State> states(triangulation.num_vertices(), State::ratio_fails);
  for (const VertexId p : states.ids()) {
    if (poles.degenerate[p] != 0 || !(radii[p] <= options.rho * poles.heights[p])) continue;
    states[p] = normal_fails.is_raised(p) ? State::pending : State::interior;
  }
  return states;
}

VertexSet taken_in_at_once(const Triangulation& triangulation, const Poles& poles,
                           const Cocones& cocones, const IdVector<VertexId, SampleState>& states,
                           const BoundaryOptions& options) {
  const Conditions conditions{triangulation, poles, cocones, options.alpha_cosine};
  VertexSet taken(states.size(), 0);
  conditions.for_each_neighbor(0, cocones.facets.size(), [&](VertexId p, VertexId q) {
    if (states[p] != State::pending || states[q] != State::interior) return;
    if (conditions.normals_agree(p, q)) taken[p] = 1;
  });
  return taken;
}

BoundarySamples boundary_samples(const Triangulation& triangulation, const Dual& dual,
                                 const Poles& poles, const Cocones& cocones,
                                 const BoundaryOptions& options, const Execution& execution) {
  report_progress(execution, "boundary_samples", 0);
  const Conditions conditions{triangulation, poles, cocones, options.alpha_cosine};
  IdVector<VertexId, State> states =
      judge_samples(triangulation, dual, poles, cocones, options, execution);
  report_progress(execution, "boundary_samples", 0.8);
  BoundarySamples result;
  result.recovered = recover_pending(conditions, states);
  result.boundary = VertexSet(states.size(), 0);
  for (const VertexId p : states.ids()) {
    result.boundary[p] = states[p] != State::interior;
    result.count += result.boundary[p];
    result.ratio_failed += states[p] == State::ratio_fails;
  }
  report_progress(execution, "boundary_samples", 1);
  return result;
}

}  // namespace cocoon
