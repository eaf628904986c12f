#include "cocone/mark_cells.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "cocone/facets/half_star.h"
#include "cocone/facets/stage_inputs.h"
#include "cocone/known_labels.h"
#include "cocone/marking/carried_marks.h"
#include "cocone/marking/disputed_marks.h"
#include "cocone/marking/half_labels.h"
#include "delaunay/circulate.h"
#include "delaunay/star_cache.h"
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
                                     const CarriedMarks& carried, const CellMarks& marks) {
  std::vector<VertexId> asked = carried.disputed;
  for (const CellId c : triangulation.finite_cells()) {
    if (marks.known[c] == CellLabel::unmarked) continue;
    const bool fits = marks.known[c] == marks.labels[c];
    for (const VertexId v : triangulation.cell(c).vertices) {
      if (marks.good[v] != 0 && (!fits || marks.visited[v] == 0)) asked.push_back(v);
    }
  }
  make_set(asked);
  return asked;
}

// A closed umbrella may be no part of the surface. Where known cells tell both labels in one half
// of the star, or one label in both, it is not, and its vertex is not good.
void demote_refuted(const Triangulation& triangulation, const FacetSet& surface,
                    const CarriedMarks& carried, CellMarks& marks, const Execution& execution) {
  StarCache stars(triangulation, execution);
  HalfStar half(triangulation, surface);
  for (const VertexId v : may_be_refuted(triangulation, carried, marks)) {
    const std::span<const CellId> star = stars.star(v);
    half.flood(v, star.front());
    LabelCount flooded;
    LabelCount rest;
    for (const CellId c : star) {
      const CellLabel label = triangulation.is_infinite(c) ? CellLabel::out : marks.known[c];
      (half.contains(c) ? flooded : rest).add(label);
    }
    if (!label_halves(flooded, rest).conflict) continue;
    marks.good[v] = 0;
    ++marks.refuted_vertices;
  }
  marks.good_vertices -= marks.refuted_vertices;
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
      demote_refuted(triangulation, surface.set, carried, marks, execution);
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

MarkingRounds::MarkingRounds(const Triangulation& triangulation, const FacetSet& surface,
                             CellMarks& marks, const Execution& execution)
    : triangulation_(triangulation),
      stars_(triangulation, execution),
      surface_(surface),
      marks_(marks),
      half_(triangulation, surface),
      told_(triangulation.num_cells()) {}

void MarkingRounds::run(std::span<const VertexId> seeds, std::vector<CellId>& out_cells) {
  std::vector<VertexId> frontier;
  for (const VertexId v : seeds) {
    if (visit(v)) frontier.push_back(v);
  }
  std::vector<VertexId> next;
  while (!frontier.empty()) {
    ++marks_.rounds;
    for (const VertexId v : frontier) decide(v);
    apply(out_cells);
    next.clear();
    for (const VertexId v : frontier) append_neighbors(v, next);
    std::swap(frontier, next);
  }
}

// Takes v's turn if it is good and has not had it.
bool MarkingRounds::visit(VertexId v) {
  if (marks_.good[v] == 0 || marks_.visited[v] != 0) return false;
  marks_.visited[v] = 1;
  ++marks_.visited_vertices;
  return true;
}

void MarkingRounds::decide(VertexId v) {
  const std::span<const CellId> star = stars_.star(v);
  bool complete = true;
  for (const CellId c : star) complete &= marks_.labels[c] != CellLabel::unmarked;
  if (complete) return;
  half_.flood(v, star.front());
  LabelCount flooded;
  LabelCount rest;
  for (const CellId c : star) (half_.contains(c) ? flooded : rest).add(marks_.labels[c]);
  const HalfLabels labels = label_halves(flooded, rest);
  marks_.conflicts += labels.conflict ? 1U : 0U;
  propose(v, labels.first, labels.second);
}

// What the halves of star(v) are to be: that flooded last, and the rest.
void MarkingRounds::propose(VertexId v, CellLabel flooded, CellLabel rest) {
  for (const CellId c : stars_.star(v)) {
    if (marks_.labels[c] != CellLabel::unmarked) continue;
    proposals_.push_back({c, half_.contains(c) ? flooded : rest});
  }
}

void MarkingRounds::apply(std::vector<CellId>& out_cells) {
  for (const Proposal& p : proposals_) {
    told_[p.cell] =
        static_cast<std::uint8_t>(told_[p.cell] + (p.label == CellLabel::out ? 1U : 16U));
  }
  for (const Proposal& p : proposals_) {
    std::uint8_t& told = told_[p.cell];
    if (told == 0) continue;  // done: cells are proposed several times
    const LabelCount count{told & 15U, std::size_t{told} >> 4};
    marks_.conflicts += count.mixed() ? 1U : 0U;
    marks_.labels[p.cell] = count.majority();
    if (marks_.labels[p.cell] == CellLabel::out) out_cells.push_back(p.cell);
    told = 0;
  }
  proposals_.clear();
}

// The good vertices on the surface's triangles at v that have not had their turn.
void MarkingRounds::append_neighbors(VertexId v, std::vector<VertexId>& frontier) {
  for (const CellId c : stars_.star(v)) {
    const unsigned facets = surface_.bits(c);
    if (facets == 0) continue;
    const Cell& cell = triangulation_.cell(c);
    const int opposite_facet = index_of_vertex(cell, v);
    for (int i = 0; i < 4; ++i) {
      if (i == opposite_facet || ((facets >> i) & 1U) == 0) continue;
      for (const int k : facet_corners[i]) {
        const VertexId w = cell.vertices[static_cast<std::size_t>(k)];
        if (visit(w)) frontier.push_back(w);
      }
    }
  }
}

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
  CellMarks marks;
  marks.good = std::move(good.good);
  marks.good_vertices = good.count;
  marks.folded = std::move(good.folded);
  CarriedMarks carried = carry_marks(triangulation, surface, good.corner_at, {}, marks, execution);
  if (!carried.disputed.empty()) {
    settle(triangulation, surface, good.corner_at, std::move(carried), known, marks, execution);
  }
  report_progress(execution, "mark_cells", 1);
  return marks;
}

}  // namespace cocoon
