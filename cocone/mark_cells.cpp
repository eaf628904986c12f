#include "cocone/mark_cells.h"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "cocone/facets/good_parts.h"
#include "cocone/facets/half_star.h"
#include "cocone/inputs/stage_inputs.h"
#include "cocone/known_labels.h"
#include "cocone/marking/carried_marks.h"
#include "cocone/marking/disputed_marks.h"
#include "cocone/marking/half_labels.h"
#include "delaunay/star_cache.h"
#include "geom/arrays/disjoint_sets.h"
#include "geom/arrays/sort_ids.h"
#include "geom/messages/require_size.h"

namespace cocoon {
namespace {

struct BeforeTheRounds {
  IdVector<CellId, CellLabel> labels;  // empty: nothing is known
  std::vector<VertexId> seeds;         // the first to have their turn
};

// The known labels of cells that touch a good vertex: others are left to the peel, and to the
// clean-up, which has them of `marks`. Seeds are the good vertices of those cells and on the hull.
BeforeTheRounds before_the_rounds(const Triangulation& triangulation, CellMarks& marks) {
  BeforeTheRounds before;
  VertexSet is_seed(triangulation.num_vertices(), 0);
  for (const CellId c : triangulation.infinite_cells()) {
    for (int i = 0; i < 3; ++i) is_seed[triangulation.vertex(c, i)] = 1;
  }
  before.labels = marks.known;
  const std::size_t labeled = before.labels.empty() ? 0 : triangulation.num_finite_cells();
  for (const CellId c : id_range<CellId>(labeled)) {
    if (before.labels[c] == CellLabel::unmarked) continue;
    if (is_poor(triangulation, marks.good, c)) {
      before.labels[c] = CellLabel::unmarked;
      continue;
    }
    ++marks.known_cells;
    for (const VertexId v : triangulation.cell(c).vertices) is_seed[v] = 1;
  }
  for (const VertexId v : is_seed.ids()) {
    if (is_seed[v] != 0 && marks.good[v] != 0) before.seeds.push_back(v);
  }
  return before;
}

// Of the good vertices those that known cells may refute. At all others, visited ones, the labels
// that were carried fit the surface, and what is known of their cells. At those that were not
// visited cells may have labels from other vertices, which need not fit.
std::vector<VertexId> may_be_refuted(const Triangulation& triangulation,
                                     const IdVector<CellId, CellLabel>& known,
                                     const CarriedMarks& carried, const CellMarks& marks) {
  std::vector<VertexId> asked = carried.disputed;
  for (const CellId c : triangulation.finite_cells()) {
    if (known[c] == CellLabel::unmarked) continue;
    const bool fits = known[c] == marks.labels[c];
    for (const VertexId v : triangulation.cell(c).vertices) {
      if (marks.good[v] != 0 && (!fits || marks.visited[v] == 0)) asked.push_back(v);
    }
  }
  make_set(asked);
  return asked;
}

// Takes the flags of the good vertices over.
CellMarks no_marks(GoodVertices& good) {
  CellMarks marks;
  marks.good = std::move(good.good);
  marks.good_vertices = good.count;
  marks.folded = std::move(good.folded);
  return marks;
}

void demote(VertexId v, CellMarks& marks) {
  marks.good[v] = 0;
  ++marks.refuted_vertices;
  --marks.good_vertices;
}

// A closed umbrella may be no part of the surface. Where known cells tell both labels in one half
// of the star, or one label in both, it is not, and its vertex is not good.
void demote_refuted(const Triangulation& triangulation, const FacetSet& surface,
                    const IdVector<CellId, CellLabel>& known, const CarriedMarks& carried,
                    CellMarks& marks, const Execution& execution) {
  StarCache stars(triangulation, execution);
  HalfStar half(triangulation, surface);
  for (const VertexId v : may_be_refuted(triangulation, known, carried, marks)) {
    const std::span<const CellId> star = stars.star(v);
    half.flood(v, star.front());
    LabelCount flooded;
    LabelCount rest;
    for (const CellId c : star) {
      const CellLabel label = triangulation.is_infinite(c) ? CellLabel::out : known[c];
      (half.contains(c) ? flooded : rest).add(label);
    }
    if (label_halves(flooded, rest).conflict) demote(v, marks);
  }
}

// Good vertices that no mark reached, on parts of the surface that the labeled cells touch.
void demote_unvisited_beside(const IdVector<CellId, CellLabel>& labels,
                             const Triangulation& triangulation, const FacetSet& surface,
                             CellMarks& marks) {
  DisjointSets parts(triangulation.num_vertices());
  surface.for_each(triangulation, [&](FacetId f) {
    join_good(parts, triangulation.facet_vertices(f),
              [&](VertexId v) { return is_unvisited(marks, v); });
  });
  std::vector<std::uint8_t> is_touched(triangulation.num_vertices(), 0);  // by the root of a part
  for (const CellId c : triangulation.finite_cells()) {
    if (labels[c] == CellLabel::unmarked) continue;
    for (const VertexId v : triangulation.cell(c).vertices) {
      if (is_unvisited(marks, v)) is_touched[parts.root(v.value)] = 1;
    }
  }
  for (const VertexId v : marks.good.ids()) {
    if (is_unvisited(marks, v) && is_touched[parts.root(v.value)] != 0) demote(v, marks);
  }
}

// Where vertices disagree.
void settle(const Triangulation& triangulation, const LinkedFacets& surface,
            const IdVector<VertexId, Halfedge>& corner_at, CarriedMarks carried,
            const KnownLabelsSource& source, CellMarks& marks, const Execution& execution) {
  if (source) {
    marks.known = source(triangulation, surface.set, execution).labels;
    if (!marks.known.empty()) {
      require_size("mark_cells", "known labels of cells", marks.known.size(),
                   triangulation.num_cells());
      demote_refuted(triangulation, surface.set, marks.known, carried, marks, execution);
    }
  }
  const BeforeTheRounds before = before_the_rounds(triangulation, marks);
  const bool all_carried = std::all_of(before.seeds.begin(), before.seeds.end(),
                                       [&](VertexId v) { return marks.visited[v] != 0; });
  if (!all_carried || marks.refuted_vertices > 0) {
    // The known cells tell of parts of the surface that the hull does not see.
    carried = carry_marks(triangulation, surface, corner_at, before.labels, marks, execution);
  }
  settle_disputes(triangulation, surface, corner_at, carried, before.seeds, before.labels, marks,
                  execution);
}

}  // namespace

CellMarks mark_cells(const Triangulation& triangulation, const LinkedFacets& surface,
                     const VertexSet& boundary, const GoodVertexOptions& options,
                     const Execution& execution) {
  return mark_cells(triangulation, surface, boundary, KnownLabelsSource(), options, execution);
}

CellMarks mark_cells(const Triangulation& triangulation, const LinkedFacets& surface,
                     const VertexSet& boundary, const KnownLabelsSource& known,
                     const GoodVertexOptions& options, const Execution& execution) {
  require_facets("mark_cells", triangulation, surface);
  require_vertex_flags("mark_cells", triangulation, boundary);
  return mark_cells(triangulation, surface, good_vertices(surface, boundary, options, execution),
                    known, execution);
}

CellMarks mark_cells(const Triangulation& triangulation, const LinkedFacets& surface,
                     GoodVertices good, const KnownLabelsSource& known,
                     const Execution& execution) {
  require_facets("mark_cells", triangulation, surface);
  require_vertex_flags("mark_cells", triangulation, good.good);
  report_progress(execution, "mark_cells", 0);
  CellMarks marks = no_marks(good);
  CarriedMarks carried = carry_marks(triangulation, surface, good.corner_at, {}, marks, execution);
  if (!carried.disputed.empty()) {
    settle(triangulation, surface, good.corner_at, std::move(carried), known, marks, execution);
  }
  report_progress(execution, "mark_cells", 1);
  return marks;
}

CellMarks mark_undoubted_cells(const Triangulation& triangulation, const LinkedFacets& surface,
                               GoodVertices good, const IdVector<CellId, CellLabel>& known,
                               const IdVector<CellId, CellLabel>& likely,
                               const Execution& execution) {
  require_facets("mark_undoubted_cells", triangulation, surface);
  require_vertex_flags("mark_undoubted_cells", triangulation, good.good);
  for (const auto* labels : {&known, &likely}) {
    require_size("mark_undoubted_cells", "labels of cells", labels->size(),
                 triangulation.num_cells());
  }
  report_progress(execution, "mark_cells", 0);
  CellMarks marks = no_marks(good);
  const auto carry = [&] {
    return carry_marks(triangulation, surface, good.corner_at, {}, marks, execution);
  };
  CarriedMarks carried = carry();
  demote_refuted(triangulation, surface.set, known, carried, marks, execution);
  if (marks.refuted_vertices > 0) carried = carry();
  demote_unvisited_beside(likely, triangulation, surface.set, marks);
  if (!carried.disputed.empty()) {
    const BeforeTheRounds before = before_the_rounds(triangulation, marks);
    settle_disputes(triangulation, surface, good.corner_at, carried, before.seeds, before.labels,
                    marks, execution);
  }
  report_progress(execution, "mark_cells", 1);
  return marks;
}

}  // namespace cocoon
