#include "cocone/marking/marking_rounds.h"

#include <utility>

#include "cocone/marking/half_labels.h"
#include "delaunay/circulate.h"

namespace cocoon {

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

}  // namespace cocoon
