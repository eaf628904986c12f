#include "ref/mark_in_rounds.h"

#include <vector>

#include "ref/marking_rounds.h"

namespace cocoon::ref {
namespace {

class MarkedTriangulation {
 public:
  using Cell = CellId;
  using Vertex = VertexId;

  MarkedTriangulation(const Triangulation& triangulation, const FacetSet& surface, CellMarks& marks)
      : triangulation_(triangulation),
        surface_(surface),
        marks_(marks),
        stars_(triangulation.num_vertices()),
        notes_(triangulation.num_cells()) {
    for (const CellId c : triangulation.cells()) {
      notes_[c].side = static_cast<Side>(marks.labels[c]);
      for (int i = 0; i < 4; ++i) {
        if (vertex(c, i) != infinite_vertex) stars_[vertex(c, i)].push_back(c);
      }
    }
  }

  const std::vector<Cell>& star(Vertex v) const { return stars_[v]; }
  Vertex vertex(Cell c, int i) const { return triangulation_.vertex(c, i); }
  Cell neighbor(Cell c, int i) const { return triangulation_.neighbor(c, i); }
  bool on_surface(Cell c, int i) const { return surface_.contains(facet_id(c, i)); }
  CellNotes& notes(Cell c) { return notes_[c]; }
  bool take_turn(Vertex v) {
    if (v == infinite_vertex || marks_.good[v] == 0 || marks_.visited[v] != 0) return false;
    marks_.visited[v] = 1;
    ++marks_.visited_vertices;
    return true;
  }

 private:
  const Triangulation& triangulation_;
  const FacetSet& surface_;
  CellMarks& marks_;
  IdVector<VertexId, std::vector<CellId>> stars_;
  IdVector<CellId, CellNotes> notes_;
};

}  // namespace

void mark_in_rounds(const Triangulation& triangulation, const FacetSet& surface,
                    std::span<const VertexId> seeds, CellMarks& marks) {
  for (const CellId c : triangulation.infinite_cells()) marks.labels[c] = CellLabel::out;
  MarkedTriangulation marked(triangulation, surface, marks);
  const RoundCounts counts = MarkingRounds(marked).run({seeds.begin(), seeds.end()});
  marks.rounds += counts.rounds;
  marks.conflicts += counts.conflicts;
  for (const CellId c : triangulation.cells()) {
    marks.labels[c] = static_cast<CellLabel>(marked.notes(c).side);
  }
}

}  // namespace cocoon::ref
