// Marking: which cells lie outside and which inside, told by the good vertices of the surface.
//
// At a good vertex the surface is one disk, which divides the cells around it (the infinite ones
// included) into two halves. A half that holds a cell known to be OUT is outside, the other one is
// inside. Beginning with the infinite cells, marks travel over the surface from good vertex to good
// vertex.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "cocone/facet_set.h"
#include "cocone/facets/half_star.h"
#include "cocone/facets/linked_facets.h"
#include "cocone/known_labels.h"
#include "cocone/umbrella.h"
#include "delaunay/star_cache.h"
#include "delaunay/triangulation.h"
#include "geom/arrays/zeroed_array.h"
#include "geom/execution.h"

namespace cocoon {

struct CellMarks {
  IdVector<CellId, CellLabel> labels;
  VertexSet good;                // vertices that may tell the sides of the surface apart
  VertexSet visited;             // good vertices that have done so
  std::vector<VertexId> folded;  // closed umbrellas at folds or creases (umbrella.h); increasing
  // Labels told beforehand (known_labels.h); empty if there are none, or if they were not asked
  // for.
  IdVector<CellId, CellLabel> known;
  // After peel_cells: 1 = reached from infinity. The body is the set of finite cells not reached.
  IdVector<CellId, std::uint8_t> reached;
  // After peel_cells, empty if there are no conflicts up to then: 1 = a good vertex whose cells are
  // not OUT on one side of the surface and IN (or unmarked) on the other.
  VertexSet contradicted;

  std::size_t good_vertices = 0;
  std::size_t visited_vertices = 0;
  std::size_t refuted_vertices = 0;  // closed umbrellas that known cells contradict: not good
  std::size_t rounds = 0;            // 0: no two vertices disagreed, one pass decided
  std::size_t known_cells = 0;       // that had their labels before the rounds
  std::size_t conflicts = 0;         // halves, or cells, that were told both; see below
  std::size_t deferred_seeds = 0;    // of peel_cells
  std::size_t poor_cells = 0;        // of peel_cells: cells without a good vertex
};

// Whether a vertex of a finite cell is in the set. O(1).
inline bool has_vertex_in(const VertexSet& set, const Cell& cell) {
  const auto& [v0, v1, v2, v3] = cell.vertices;
  return (set[v0] | set[v1] | set[v2] | set[v3]) != 0;
}

// Whether no vertex of a finite cell is good: none can tell on which side the cell is. O(1).
inline bool is_poor(const Triangulation& triangulation, const VertexSet& good, CellId c) {
  return !has_vertex_in(good, triangulation.cell(c));
}

// Whether it is told beforehand on which side a finite cell is: nothing else is to decide that.
// O(1).
inline bool is_known(const CellMarks& marks, CellId c) {
  return !marks.known.empty() && marks.known[c] != CellLabel::unmarked;
}

// Whether a good vertex is contradicted by labels around it. O(1).
inline bool is_contradicted(const CellMarks& marks, VertexId v) {
  return marks.conflicts != 0 && marks.contradicted[v] != 0;
}

// Labels all infinite cells OUT and runs rounds: the good vertices on triangles of the last round's
// vertices (at first: of infinite cells) are all decided from the labels of earlier rounds, then
// their stars are labeled. A half that holds OUT cells and no IN cells is outside, and the other
// way round; where both labels occur the half's majority counts, a tie is OUT, and it is counted as
// a conflict. Nothing is overwritten; a cell told both in one round takes what most of its vertices
// say, of two and two OUT, also counted.
// A vertex whose star is labeled already passes on the turn and is not examined for conflicts.
// One pass over the cells (carried_marks.h) gives the same labels where no two vertices disagree;
// of the others those are asked, round by round, whom the disagreement touches (disputed_marks.h).
// Errors: InputError for parts of another triangulation, by their sizes (facets/stage_inputs.h).
// Complexity: O(cells). Rounds read only earlier rounds: independent of order.
// Source: Dey & Goswami 2003 (Tight Cocone, marking); rounds and majorities are ours,
// docs/stages/mark_cells.md.
CellMarks mark_cells(const Triangulation& triangulation, const LinkedFacets& surface,
                     const VertexSet& boundary, const GoodVertexOptions& options = {},
                     const Execution& execution = {});

// The same with labels that are known beforehand. Here they count only where vertices disagree (the
// clean-up heeds CellMarks::known elsewhere, too), which is where marks may have gone astray: then
// the known cells that touch a good vertex have their labels before the first round, and their good
// vertices are among the first. Good vertices whose halves known cells contradict are no longer
// good (refuted_vertices).
CellMarks mark_cells(const Triangulation& triangulation, const LinkedFacets& surface,
                     const VertexSet& boundary, const KnownLabelsSource& known,
                     const GoodVertexOptions& options = {}, const Execution& execution = {});

// The same where the good vertices are known: good_vertices(surface, boundary, options).
CellMarks mark_cells(const Triangulation& triangulation, const LinkedFacets& surface,
                     GoodVertices good, const KnownLabelsSource& known,
                     const Execution& execution = {});

// The rounds by themselves, for the peel that discovers further seeds.
class MarkingRounds {
 public:
  // All references must outlive the object.
  MarkingRounds(const Triangulation& triangulation, const FacetSet& surface, CellMarks& marks,
                const Execution& execution);

  // Runs rounds from these vertices to the end; those not good or already visited are skipped, the
  // others must touch a labeled cell. Newly labeled OUT cells are appended to `out_cells`.
  void run(std::span<const VertexId> seeds, std::vector<CellId>& out_cells);

 private:
  struct Proposal {
    CellId cell;
    CellLabel label;
  };
  bool visit(VertexId v);
  void decide(VertexId v);
  void propose(VertexId v, CellLabel flooded, CellLabel rest);
  void apply(std::vector<CellId>& out_cells);
  void append_neighbors(VertexId v, std::vector<VertexId>& frontier);

  const Triangulation& triangulation_;
  StarCache stars_;
  const FacetSet& surface_;
  CellMarks& marks_;
  HalfStar half_;
  ZeroedArray<CellId, std::uint8_t> told_;  // scratch, zero between uses: what a round proposes
  std::vector<Proposal> proposals_;
};

}  // namespace cocoon
