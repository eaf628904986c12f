// What is known of the surface of a changing set of points (dynamic_tight_cocone.h), as plain data
// beside its triangulation: to be kept elsewhere and taken up again.
#pragma once

#include <cstddef>
#include <cstdint>

#include "cocone/boundary_samples.h"
#include "cocone/cell_marks.h"
#include "delaunay/triangulation.h"
#include "geom/execution.h"
#include "geom/id_vector.h"
#include "geom/point.h"

namespace cocoon {

// Bits of CandidateState::vertex_flags.
namespace vertex_flag {
inline constexpr unsigned on_hull = 1;
inline constexpr unsigned degenerate = 2;  // its pole (poles.h)
inline constexpr unsigned umbrella = 4;    // of candidates (prune_sharp_edges.h)
}  // namespace vertex_flag

// Bits of CandidateState::cell_flags.
namespace cell_flag {
inline constexpr unsigned candidate_facets = 15;  // bit i: facet i is a candidate
inline constexpr unsigned exact_center = 16;      // how the circumcenter was obtained
inline constexpr unsigned facet_center = 32;
inline constexpr unsigned infinite = 64;
inline constexpr unsigned finite = 128;
}  // namespace cell_flag

// Bits of SurfaceState::sides of a cell, for its facet 0: it is on the surface, and the cell lies
// on the outer, or inner, side. Shifted by i: for facet i.
namespace side_flag {
inline constexpr unsigned outer = 1;
inline constexpr unsigned inner = 16;
}  // namespace side_flag

// Bits of MarkState::cells and MarkState::vertices.
namespace mark_flag {
inline constexpr unsigned surface_facets = 15;  // bit i: facet i is on the surface
inline constexpr unsigned label_shift = 4;      // of the label (CellLabel)
inline constexpr unsigned label = 3U << label_shift;
inline constexpr unsigned good = 1;
inline constexpr unsigned folded = 2;
}  // namespace mark_flag

// What the surface is at a vertex. `good` and `folded`: one closed umbrella; folded ones do not
// tell inside from outside (umbrella.h).
enum class SheetAt : std::uint8_t { none = 0, folded, good };

// How many of the flags of four facets are set. Complexity: O(1); std::popcount would be a call,
// since builds are for any x86-64 processor.
constexpr std::size_t num_flags(unsigned four) {
  return static_cast<std::size_t>(0x4332322132212110U >> (4 * four) & 15U);
}

// Of the stages from the poles to pruning (live_candidates.h). By slot, while the triangulation is
// that of a DynamicDelaunay.
struct CandidateState {
  IdVector<VertexId, Vec3> normals;
  IdVector<VertexId, std::uint8_t> vertex_flags;
  IdVector<VertexId, SampleState> samples;
  // Of phase 2, until the sample was taken in: 0 if it is interior without that, not_taken_in if
  // it is a boundary sample.
  IdVector<VertexId, std::uint32_t> steps;
  IdVector<CellId, std::uint8_t> cell_flags;
  IdVector<CellId, std::uint8_t> pruned;  // bit i: facet i is a candidate that was pruned

  // Bit i: facet i of the cell is a candidate that was not pruned. O(1).
  unsigned left(CellId c) const {
    return cell_flags[c] & ~unsigned{pruned[c]} & cell_flag::candidate_facets;
  }
  friend bool operator==(const CandidateState&, const CandidateState&) = default;
};
inline constexpr std::uint32_t not_taken_in = 0xFFFFFFFFU;

// What the marking told of the Cocone surface, if all good vertices told it without contradiction
// (kept_marks.h); empty: it did not.
struct MarkState {
  IdVector<CellId, std::uint8_t> cells;
  IdVector<VertexId, std::uint8_t> vertices;

  bool empty() const { return cells.empty(); }
  // The label among the flags of a cell. O(1).
  static CellLabel label_of(unsigned cell) {
    return static_cast<CellLabel>((cell & mark_flag::label) >> mark_flag::label_shift);
  }
  friend bool operator==(const MarkState&, const MarkState&) = default;
};

// Empty: nothing is known.
struct SurfaceState {
  CandidateState candidates;
  // Of the certified surface; empty if there is none.
  IdVector<CellId, std::uint8_t> sides;
  IdVector<VertexId, SheetAt> sheets;
  // Of another one, which bounds a body; empty: not known.
  MarkState marks;
  IdVector<CellId, std::uint8_t> out;  // 1: not of the body, as no infinite cell is

  // Whether it tells a surface.
  bool has_surface() const { return !sides.empty() || !out.empty(); }
  // Keeps only the candidates.
  void forget_surface();

  bool empty() const { return candidates.cell_flags.empty(); }
  friend bool operator==(const SurfaceState&, const SurfaceState&) = default;
};

// Throws InputError, one line, unless sizes are those of the triangulation, every value is one that
// can be, both sides of each facet say the same, the surface has the vertices that it should, and
// marks change at good vertices across the surface and nowhere else.
// Whether all this is what the stages would find is not looked at. Complexity: O(cells).
void check_surface_state(const Triangulation& triangulation, const SurfaceState& state,
                         const Execution& execution = {});

}  // namespace cocoon
