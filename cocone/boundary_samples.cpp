#include "cocone/boundary_samples.h"

#include <algorithm>
#include <bit>
#include <utility>
#include <vector>

#include "cocone/inputs/stage_inputs.h"
#include "cocone/samples/cocone_radii.h"
#include "cocone/samples/facet_doubts.h"
#include "cocone/samples/shared_flags.h"
#include "geom/parallel/parallel_list.h"

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
  const Dual& dual;
  const Poles& poles;
  const Cocones& cocones;
  const BoundaryOptions& options;
  std::vector<FacetDoubts> doubts;  // of the facets of `cocones`

  Conditions(const Triangulation& of, const Dual& its_dual, const Poles& its_poles,
             const Cocones& its_cocones, const BoundaryOptions& given, const Execution& execution)
      : triangulation(of),
        dual(its_dual),
        poles(its_poles),
        cocones(its_cocones),
        options(given),
        doubts(facet_doubts(of, its_poles, its_cocones, given, execution)) {}

  // Calls visit(p, q, agree) for p in N_q as facet k tells it, with what their normals do.
  template <class Visit>
  void for_each_neighbor(std::size_t k, Visit visit) const {
    for_each_cocone_neighbor(cocones, k, [&](VertexId p, VertexId q, std::size_t i) {
      visit(p, q, (doubts[k] >> (3 + i) & 1U) == 0);
    });
  }
};

// Raised: the normal condition fails.
SharedFlags failing_normals(const Conditions& conditions, const Execution& execution) {
  SharedFlags fails(conditions.triangulation.num_vertices());
  parallel_chunks(execution, conditions.doubts.size(), facets_per_chunk,
                  [&](std::size_t begin, std::size_t end) {
                    for (std::size_t k = begin; k < end; ++k) {
                      if ((conditions.doubts[k] & normals_disagree) == 0) continue;
                      conditions.for_each_neighbor(k, [&](VertexId p, VertexId, bool agree) {
                        if (!agree) fails.raise(p);
                      });
                    }
                  });
  return fails;
}

// Samples whose ratio condition the facets alone do not show to hold.
VertexSet doubtful_ratios(const Conditions& conditions, const Execution& execution) {
  SharedFlags raised(conditions.triangulation.num_vertices());
  parallel_chunks(execution, conditions.doubts.size(), facets_per_chunk,
                  [&](std::size_t begin, std::size_t end) {
                    for (std::size_t k = begin; k < end; ++k) {
                      unsigned open = conditions.doubts[k] & ratio_doubts;
                      for (; open != 0; open &= open - 1) {
                        const auto i = static_cast<std::size_t>(std::countr_zero(open));
                        raised.raise(conditions.cocones.corners[k][i]);
                      }
                    }
                  });
  VertexSet doubtful = std::move(raised).take();
  if (conditions.options.radius_mode == RadiusMode::tangent_plane) {
    for (const VertexId v :
         unbounded_in_plane(conditions.triangulation, conditions.dual, conditions.poles)) {
      doubtful[v] = 1;
    }
  }
  return doubtful;
}

// Flagged: the ratio condition fails. Radii are computed where it is in doubt.
VertexSet failing_ratios(const Conditions& conditions, const Execution& execution) {
  const Poles& poles = conditions.poles;
  const BoundaryOptions& options = conditions.options;
  VertexSet fails = doubtful_ratios(conditions, execution);
  if (std::find(fails.begin(), fails.end(), 1) != fails.end()) {
    const IdVector<VertexId, double> radii =
        cocone_radii(conditions.triangulation, conditions.dual, poles, conditions.cocones,
                     options.radius_mode, fails, execution);
    for (const VertexId p : fails.ids()) {
      if (radii[p] <= options.rho * poles.heights[p]) fails[p] = 0;
    }
  }
  for (const VertexId p : fails.ids()) fails[p] |= poles.degenerate[p];
  return fails;
}

using State = SampleState;

// Phase 2: the least fixed point, from the interior samples outward along p in N_q with agreeing
// normals and p pending. In order of steps.
std::vector<TakenIn> take_in_pending(const Conditions& conditions, IdVector<VertexId, State> states,
                                     const Execution& execution) {
  if (std::find(states.begin(), states.end(), State::pending) == states.end()) return {};
  std::vector<NeighborOf> steps = parallel_list<NeighborOf>(
      execution, conditions.cocones.facets.size(), facets_per_chunk,
      [&](std::size_t begin, std::size_t end, std::vector<NeighborOf>& found) {
        const auto is_pending = [&](VertexId v) { return states[v] == State::pending; };
        for (std::size_t k = begin; k < end; ++k) {
          const auto [a, b, c] = conditions.cocones.corners[k];
          if (!is_pending(a) && !is_pending(b) && !is_pending(c)) continue;
          conditions.for_each_neighbor(k, [&](VertexId p, VertexId q, bool agree) {
            if (!is_pending(p) || states[q] == State::ratio_fails) return;
            if (agree) found.push_back({q, p});
          });
        }
      });
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

// Phase 1.
IdVector<VertexId, State> judge(const Conditions& conditions, const Execution& execution) {
  const VertexSet ratio_fails = failing_ratios(conditions, execution);
  const SharedFlags normal_fails = failing_normals(conditions, execution);
  IdVector<VertexId, State> states(ratio_fails.size(), State::ratio_fails);
  for (const VertexId p : states.ids()) {
    if (ratio_fails[p] != 0) continue;
    states[p] = normal_fails.is_raised(p) ? State::pending : State::interior;
  }
  return states;
}

void require_inputs(const char* stage, const Triangulation& triangulation, const Dual& dual,
                    const Poles& poles, const Cocones& cocones, const BoundaryOptions& options) {
  require_options(stage, options);
  require_dual(stage, triangulation, dual);
  require_poles(stage, triangulation, poles);
  require_cocones(stage, triangulation, cocones);
}

}  // namespace

IdVector<VertexId, SampleState> judge_samples(const Triangulation& triangulation, const Dual& dual,
                                              const Poles& poles, const Cocones& cocones,
                                              const BoundaryOptions& options,
                                              const Execution& execution) {
  require_inputs("judge_samples", triangulation, dual, poles, cocones, options);
  return judge({triangulation, dual, poles, cocones, options, execution}, execution);
}

BoundarySamples boundary_samples(const Triangulation& triangulation, const Dual& dual,
                                 const Poles& poles, const Cocones& cocones,
                                 const BoundaryOptions& options, const Execution& execution) {
  require_inputs("boundary_samples", triangulation, dual, poles, cocones, options);
  report_progress(execution, "boundary_samples", 0);
  const Conditions conditions(triangulation, dual, poles, cocones, options, execution);
  BoundarySamples result;
  result.states = judge(conditions, execution);
  report_progress(execution, "boundary_samples", 0.8);
  result.taken_in = take_in_pending(conditions, result.states, execution);
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
