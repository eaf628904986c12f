#include "cocone/live/surface_state.h"

#include <algorithm>
#include <string>

#include "geom/errors.h"
#include "geom/parallel/parallel_reduce.h"

namespace cocoon {
namespace {

void require(bool condition, const char* what) {
  if (!condition)
    throw InputError(std::string("what is known of the surface does not fit: ") + what);
}

template <class Holds>
void require_at_cells(const Execution& execution, std::size_t cells, const char* what,
                      const Holds& holds) {
  const std::size_t wrong =
      first_failing(execution, cells, [&](std::size_t c) { return holds(CellId(c)); });
  if (wrong < cells) require(false, (what + std::to_string(wrong)).c_str());
}

template <class Range, class Test>
void require_all(const Range& range, Test test, const char* what) {
  require(std::all_of(range.begin(), range.end(), test), what);
}

// The flags of facet f, all above them shifted away.
unsigned flags_at(const IdVector<CellId, std::uint8_t>& flags, FacetId f) {
  return static_cast<unsigned>(flags[cell_of(f)] >> index_of(f));
}

// Whether it holds for each facet of the cell whose flag is set.
template <class Holds>
bool all_facets(CellId c, unsigned flags, const Holds& holds) {
  for (int i = 0; (flags >> i) != 0; ++i) {
    if (((flags >> i) & 1U) != 0 && !holds(facet_id(c, i))) return false;
  }
  return true;
}

// Of a facet with one of these flags; the cell behind it finds out if only that one has it.
bool is_possible(const Triangulation& triangulation, const CandidateState& state, FacetId f) {
  const FacetId m = triangulation.mirror(f);
  const unsigned candidate = flags_at(state.cell_flags, f) & flags_at(state.cell_flags, m) & 1U;
  const unsigned pruned = flags_at(state.pruned, f) ^ flags_at(state.pruned, m);
  return candidate != 0 && (pruned & 1U) == 0 && triangulation.is_finite_facet(f);
}

bool is_possible(const Triangulation& triangulation, const CandidateState& state, CellId c) {
  const unsigned flags = state.cell_flags[c];
  const unsigned kind = triangulation.is_infinite(c) ? cell_flag::infinite : cell_flag::finite;
  const unsigned facets = (flags & cell_flag::candidate_facets) | state.pruned[c];
  return (flags & (cell_flag::infinite | cell_flag::finite)) == kind && state.pruned[c] < 16 &&
         all_facets(c, facets, [&](FacetId f) { return is_possible(triangulation, state, f); });
}

// Facets of the surface are candidates that were not pruned; each has an outer and an inner side.
bool has_possible_sides(const Triangulation& triangulation, const SurfaceState& state, CellId c) {
  constexpr unsigned both = side_flag::outer | side_flag::inner;
  const unsigned sides = state.sides[c];
  const unsigned on_surface = (sides | sides >> 4) & 15U;
  return (on_surface & ~state.candidates.left(c)) == 0 && all_facets(c, on_surface, [&](FacetId f) {
           const unsigned here = flags_at(state.sides, f) & both;
           const unsigned behind = flags_at(state.sides, triangulation.mirror(f)) & both;
           return here != both && here + behind == both;
         });
}

// Bit i: vertex i of the cell is good.
unsigned good_corners(const Triangulation& triangulation, const MarkState& marks, CellId c) {
  const auto& vertices = triangulation.cell(c).vertices;
  unsigned good = 0;
  for (unsigned i = 0; i < 4; ++i) {
    if (vertices[i] == infinite_vertex) continue;
    good |= (marks.vertices[vertices[i]] & mark_flag::good) << i;
  }
  return good;
}

// Infinite cells are OUT; of the others those have a label that have a good vertex. At one the
// label changes across the surface, and nowhere else.
bool has_possible_label(const Triangulation& triangulation, const MarkState& marks, CellId c) {
  const CellLabel label = MarkState::label_of(marks.cells[c]);
  const unsigned good = good_corners(triangulation, marks, c);
  bool possible = triangulation.is_infinite(c) ? label == CellLabel::out
                                               : (label == CellLabel::unmarked) == (good == 0);
  for (int i = 0; i < 4; ++i) {
    if ((good & ~(1U << i)) == 0) continue;
    const bool changes = MarkState::label_of(marks.cells[triangulation.neighbor(c, i)]) != label;
    possible = possible && changes == ((flags_at(marks.cells, facet_id(c, i)) & 1U) != 0);
  }
  return possible;
}

// Marked facets are candidates that were not pruned, from both sides.
bool has_possible_marks(const Triangulation& triangulation, const SurfaceState& state, CellId c) {
  const unsigned marks = state.marks.cells[c];
  const unsigned on_surface = marks & mark_flag::surface_facets;
  return (marks & ~(mark_flag::surface_facets | mark_flag::label)) == 0 &&
         (marks & mark_flag::label) != mark_flag::label &&
         (on_surface & ~state.candidates.left(c)) == 0 &&
         all_facets(c, on_surface,
                    [&](FacetId f) {
                      return (flags_at(state.marks.cells, triangulation.mirror(f)) & 1U) != 0;
                    }) &&
         has_possible_label(triangulation, state.marks, c);
}

// The vertices of the surface, and no others, have a sheet.
void check_sheets(const Triangulation& triangulation, const SurfaceState& state) {
  require_all(
      state.sheets, [](SheetAt sheet) { return sheet <= SheetAt::good; }, "a sheet");
  VertexSet on_surface(triangulation.num_vertices(), 0);
  for (const CellId c : state.sides.ids()) {
    const unsigned outer = state.sides[c] & 15U;
    for (int i = 0; (outer >> i) != 0; ++i) {
      if (((outer >> i) & 1U) == 0) continue;
      for (const VertexId v : triangulation.facet_vertices(facet_id(c, i))) on_surface[v] = 1;
    }
  }
  for (const VertexId v : state.sheets.ids()) {
    require((state.sheets[v] != SheetAt::none) == (on_surface[v] != 0), "a vertex of the surface");
  }
}

void check_sizes(const Triangulation& triangulation, const SurfaceState& state) {
  const std::size_t vertices = triangulation.num_vertices();
  const std::size_t cells = triangulation.num_cells();
  const CandidateState& candidates = state.candidates;
  const auto fits = [](const auto& values, std::size_t count) { return values.size() == count; };
  const auto fits_or_is_empty = [&](const auto& values, std::size_t count) {
    return values.empty() || fits(values, count);
  };
  require(fits(candidates.normals, vertices) && fits(candidates.vertex_flags, vertices) &&
              fits(candidates.samples, vertices) && fits(candidates.steps, vertices) &&
              fits(candidates.cell_flags, cells) && fits(candidates.pruned, cells) &&
              fits_or_is_empty(state.sides, cells) &&
              fits(state.sheets, state.sides.empty() ? 0 : vertices) &&
              fits_or_is_empty(state.marks.cells, cells) &&
              fits(state.marks.vertices, state.marks.empty() ? 0 : vertices) &&
              fits_or_is_empty(state.out, cells),
          "other numbers of vertices or cells");
}

void check_marks(const Triangulation& triangulation, const SurfaceState& state,
                 const Execution& execution) {
  if (state.marks.empty()) return;
  require_all(
      state.marks.vertices,
      [](unsigned flags) { return flags < (mark_flag::good | mark_flag::folded); },
      "marks of a vertex");
  require_at_cells(execution, triangulation.num_cells(), "marks of cell ",
                   [&](CellId c) { return has_possible_marks(triangulation, state, c); });
}

void check_body(const Triangulation& triangulation, const SurfaceState& state,
                const Execution& execution) {
  if (state.out.empty()) return;
  require_at_cells(execution, triangulation.num_cells(), "the body at cell ", [&](CellId c) {
    return state.out[c] == 1 || (state.out[c] == 0 && !triangulation.is_infinite(c));
  });
}

}  // namespace

void SurfaceState::forget_surface() {
  sides = {};
  sheets = {};
  marks = {};
  out = {};
}

void check_surface_state(const Triangulation& triangulation, const SurfaceState& state,
                         const Execution& execution) {
  if (state.empty()) return;
  check_sizes(triangulation, state);
  const CandidateState& candidates = state.candidates;
  const std::size_t cells = triangulation.num_cells();
  require_all(
      candidates.normals, [](const Vec3& n) { return is_finite(n); }, "a normal");
  require_all(
      candidates.vertex_flags, [](unsigned flags) { return flags < 8; }, "a vertex");
  require_all(
      candidates.samples, [](SampleState s) { return s <= SampleState::interior; }, "a sample");
  require_at_cells(execution, cells, "flags of cell ",
                   [&](CellId c) { return is_possible(triangulation, candidates, c); });
  check_marks(triangulation, state, execution);
  check_body(triangulation, state, execution);
  if (state.sides.empty()) return;
  require_at_cells(execution, cells, "a side of cell ",
                   [&](CellId c) { return has_possible_sides(triangulation, state, c); });
  check_sheets(triangulation, state);
}

}  // namespace cocoon
