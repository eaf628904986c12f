#include "cocone/boundary_samples.h"

#include <algorithm>
#include <array>
#include <vector>

#include "cocone/cocone_radii.h"
#include "cocone/shared_flags.h"

namespace cocoon {
namespace {

constexpr std::size_t facets_per_chunk = 2048;

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
  const BoundaryOptions& options;

  bool agree(VertexId p, VertexId q) const { return normals_agree(poles, p, q, options); }

  // Of facet k of `cocones`.
  std::array<VertexId, 3> corners(std::size_t k) const {
    return triangulation.facet_vertices(cocones.facets[k]);
  }
  template <class Visit>
  void for_each_neighbor(std::size_t k, Visit visit) const {
    for_each_cocone_neighbor(triangulation, cocones, k, visit);
  }
};

// Raised: the normal condition fails.
SharedFlags failing_normals(const Conditions& conditions, const Execution& execution) {
  SharedFlags fails(conditions.triangulation.num_vertices());
  parallel_chunks(
      execution, conditions.cocones.facets.size(), facets_per_chunk,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
          const auto [a, b, c] = conditions.corners(k);
          // At most facets all agree, whatever cocones their dual edges meet.
          if (conditions.agree(a, b) && conditions.agree(b, c) && conditions.agree(c, a)) {
            continue;
          }
          conditions.for_each_neighbor(k, [&](VertexId p, VertexId q) {
            if (!conditions.agree(p, q)) fails.raise(p);
          });
        }
      });
  return fails;
}

using State = SampleState;

// Phase 2: the least fixed point, from the interior samples outward along p in N_q with agreeing
// normals and p pending. In order of steps.
std::vector<TakenIn> take_in_pending(const Conditions& conditions,
                                     IdVector<VertexId, State> states) {
  std::vector<NeighborOf> steps;
  for (std::size_t k = 0; k < conditions.cocones.facets.size(); ++k) {
    const auto [a, b, c] = conditions.corners(k);
    const auto is_pending = [&](VertexId v) { return states[v] == State::pending; };
    if (!is_pending(a) && !is_pending(b) && !is_pending(c)) continue;
    conditions.for_each_neighbor(k, [&](VertexId p, VertexId q) {
      if (!is_pending(p) || states[q] == State::ratio_fails) return;
      if (conditions.agree(p, q)) steps.push_back({q, p});
    });
  }
  std::vector<TakenIn> taken;
  const auto take = [&](VertexId p, std::uint32_t count) {
    if (states[p] != State::pending) return;
    states[p] = State::interior;
    taken.push_back({p, count});
  };
  const auto from_interior = [&](const NeighborOf& step) {
    return states[step.q] == State::interior;
  };
  const auto first_joining = std::partition(steps.begin(), steps.end(), from_interior);
  for (auto step = steps.begin(); step != first_joining; ++step) take(step->p, 1);
  std::sort(first_joining, steps.end());
  for (std::size_t next = 0; next < taken.size(); ++next) {
    const auto [q, count] = taken[next];
    auto step = std::lower_bound(first_joining, steps.end(), NeighborOf{q, VertexId(0)});
    for (; step != steps.end() && step->q == q; ++step) take(step->p, count + 1);
  }
  return taken;
}

}  // namespace

IdVector<VertexId, SampleState> judge_samples(const Triangulation& triangulation, const Dual& dual,
                                              const Poles& poles, const Cocones& cocones,
                                              const BoundaryOptions& options,
                                              const Execution& execution) {
  const Conditions conditions{triangulation, poles, cocones, options};
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

BoundarySamples boundary_samples(const Triangulation& triangulation, const Dual& dual,
                                 const Poles& poles, const Cocones& cocones,
                                 const BoundaryOptions& options, const Execution& execution) {
  report_progress(execution, "boundary_samples", 0);
  const Conditions conditions{triangulation, poles, cocones, options};
  BoundarySamples result;
  result.states = judge_samples(triangulation, dual, poles, cocones, options, execution);
  report_progress(execution, "boundary_samples", 0.8);
  result.taken_in = take_in_pending(conditions, result.states);
  result.recovered = result.taken_in.size();
  result.boundary = VertexSet(result.states.size(), 0);
  for (const VertexId p : result.states.ids()) {
    result.boundary[p] = result.states[p] != State::interior;
    result.count += result.boundary[p];
    result.ratio_failed += result.states[p] == State::ratio_fails;
  }
  for (const TakenIn& taken : result.taken_in) result.boundary[taken.sample] = 0;
  result.count -= result.recovered;
  report_progress(execution, "boundary_samples", 1);
  return result;
}

}  // namespace cocoon
