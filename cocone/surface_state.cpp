#include "cocone/surface_state.h"

#include <algorithm>
#include <string>

#include "geom/errors.h"

namespace cocoon {
namespace {

void require(bool condition, const char* what) {
  if (!condition)
    throw InputError(std::string("what is known of the surface does not fit: ") + what);
}

void require(bool condition, const char* what, CellId c) {
  if (!condition) require(false, (what + std::to_string(c.value)).c_str());
}

template <class Range, class Test>
void require_all(const Range& range, Test test, const char* what) {
  require(std::all_of(range.begin(), range.end(), test), what);
}

// The flags of facet f, all above them shifted away.
unsigned flags_at(const IdVector<CellId, std::uint8_t>& flags, FacetId f) {
  return static_cast<unsigned>(flags[cell_of(f)] >> index_of(f));
}

// Of a facet with one of these flags; the cell behind it finds out if only that one has it.
bool is_possible(const Triangulation& triangulation, const CandidateState& state, FacetId f) {
  const FacetId m = triangulation.mirror(f);
  const unsigned candidate = flags_at(state.cell_flags, f) & flags_at(state.cell_flags, m) & 1U;
  const unsigned pruned = flags_at(state.pruned, f) ^ flags_at(state.pruned, m);
  return candidate != 0 && (pruned & 1U) == 0 && triangulation.is_finite_facet(f);
}

void check_cells(const Triangulation& triangulation, const CandidateState& state) {
  for (const CellId c : triangulation.cells()) {
    const unsigned flags = state.cell_flags[c];
    const unsigned kind = triangulation.is_infinite(c) ? cell_flag::infinite : cell_flag::finite;
    require((flags & (cell_flag::infinite | cell_flag::finite)) == kind && state.pruned[c] < 16,
            "flags of cell ", c);
    const unsigned facets = (flags & cell_flag::candidate_facets) | state.pruned[c];
    for (int i = 0; (facets >> i) != 0; ++i) {
      require(((facets >> i) & 1U) == 0 || is_possible(triangulation, state, facet_id(c, i)),
              "a candidate of cell ", c);
    }
  }
}

// Facets of the surface are candidates that were not pruned; each has an outer and an inner side.
void check_sides(const Triangulation& triangulation, const SurfaceState& state) {
  constexpr unsigned both = side_flag::outer | side_flag::inner;
  for (const CellId c : triangulation.cells()) {
    const unsigned sides = state.sides[c];
    const unsigned on_surface = (sides | sides >> 4) & 15U;
    const unsigned left = state.candidates.cell_flags[c] & ~unsigned{state.candidates.pruned[c]};
    bool possible = (on_surface & ~left) == 0;
    for (int i = 0; (on_surface >> i) != 0; ++i) {
      if (((on_surface >> i) & 1U) == 0) continue;
      const unsigned here = flags_at(state.sides, facet_id(c, i)) & both;
      const unsigned behind = flags_at(state.sides, triangulation.mirror(facet_id(c, i))) & both;
      possible = possible && here != both && here + behind == both;
    }
    require(possible, "a side of cell ", c);
  }
}

}  // namespace

void check_surface_state(const Triangulation& triangulation, const SurfaceState& state) {
  if (state.empty()) return;
  const CandidateState& candidates = state.candidates;
  const std::size_t vertices = triangulation.num_vertices();
  const std::size_t cells = triangulation.num_cells();
  require(candidates.normals.size() == vertices && candidates.vertex_flags.size() == vertices &&
              candidates.samples.size() == vertices && candidates.steps.size() == vertices &&
              candidates.cell_flags.size() == cells && candidates.pruned.size() == cells &&
              (state.sides.empty() || state.sides.size() == cells),
          "other numbers of vertices or cells");
  require_all(
      candidates.normals, [](const Vec3& n) { return is_finite(n); }, "a normal");
  require_all(
      candidates.vertex_flags, [](unsigned flags) { return flags < 8; }, "a vertex");
  require_all(
      candidates.samples, [](SampleState s) { return s <= SampleState::interior; }, "a sample");
  check_cells(triangulation, candidates);
  if (!state.sides.empty()) check_sides(triangulation, state);
}

}  // namespace cocoon
