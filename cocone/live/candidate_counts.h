// What a CandidateState amounts to, in numbers that go along with each of its changes.
#pragma once

#include <cstddef>
#include <cstdint>

#include "cocone/live/surface_state.h"
#include "cocone/reconstruct.h"

namespace cocoon {

struct CandidateCounts {
  std::size_t boundary = 0;
  std::size_t ratio_failed = 0;
  std::size_t recovered = 0;
  std::size_t hull_vertices = 0;
  std::size_t degenerate = 0;
  std::size_t umbrellas = 0;
  std::size_t candidates = 0;  // from both sides
  std::size_t pruned = 0;      // from both sides
  std::size_t exact_centers = 0;
  std::size_t facet_centers = 0;
  std::size_t finite_cells = 0;

  // What vertex v, or cell c, contributes comes, or goes again. Complexity: O(1).
  void add(const CandidateState& state, VertexId v) { count(state, v, 1); }
  void add(const CandidateState& state, CellId c) { count(state, c, 1); }
  void subtract(const CandidateState& state, VertexId v) { count(state, v, minus_one); }
  void subtract(const CandidateState& state, CellId c) { count(state, c, minus_one); }

  // As the stages would have counted.
  void report(ReconstructCounters& counters) const;

 private:
  static constexpr auto minus_one = static_cast<std::size_t>(-1);  // sums are modulo 2^64

  static std::size_t is_set(unsigned flag) { return flag != 0 ? 1 : 0; }
  void count(const CandidateState& state, VertexId v, std::size_t step);
  void count(const CandidateState& state, CellId c, std::size_t step);
};

inline void CandidateCounts::count(const CandidateState& state, VertexId v, std::size_t step) {
  const unsigned flags = state.vertex_flags[v];
  const std::uint32_t steps = state.steps[v];
  hull_vertices += step * is_set(flags & vertex_flag::on_hull);
  degenerate += step * is_set(flags & vertex_flag::degenerate);
  umbrellas += step * is_set(flags & vertex_flag::umbrella);
  boundary += step * (steps == not_taken_in ? 1U : 0U);
  recovered += step * (steps != not_taken_in && steps != 0 ? 1U : 0U);
  ratio_failed += step * (state.samples[v] == SampleState::ratio_fails ? 1U : 0U);
}

inline void CandidateCounts::count(const CandidateState& state, CellId c, std::size_t step) {
  const unsigned flags = state.cell_flags[c];
  candidates += step * num_flags(flags & cell_flag::candidate_facets);
  pruned += step * num_flags(state.pruned[c]);
  exact_centers += step * is_set(flags & cell_flag::exact_center);
  facet_centers += step * is_set(flags & cell_flag::facet_center);
  finite_cells += step * is_set(flags & cell_flag::finite);
}

}  // namespace cocoon
