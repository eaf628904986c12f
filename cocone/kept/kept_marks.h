// The marks of a changing triangulation: where nothing has changed they are as before.
//
// What mark_cells gives can be told from the result. Where every good vertex hangs together with a
// good one on the hull, by edges of the surface between good vertices, the rounds give these
// labels, without conflict, if and only if: infinite cells are OUT; the cells with a good vertex
// are those that have a label; and of two cells that share a facet at a good vertex both have the
// same label off the surface, and different ones on it. (At each vertex in turn the labels so far
// leave one choice.) After a change
//
//   whether a vertex is good    is asked again where a cell is new, or a facet of the surface came
//                               or went, or the vertex became a boundary sample or ceased to be
//   labels                      are found again for new cells, those where a facet of the surface
//                               came or went, and those at vertices that became good or ceased to
//                               be; elsewhere cells, surface and good vertices at every facet are
//                               as before, and so are the labels
//   what hangs together         is one pass over the surface
//
// If labels cannot be found so, or there is none that fits, mark_cells runs.
// Source: ours, docs/stages/live_update.md.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "cocone/cell_marks.h"
#include "cocone/facets/linked_facets.h"
#include "cocone/known_labels.h"
#include "cocone/live/live_candidates.h"
#include "cocone/live/local_facets.h"
#include "cocone/live/surface_state.h"
#include "cocone/umbrella.h"
#include "delaunay/dynamic_delaunay.h"
#include "delaunay/renumbering.h"
#include "delaunay/star_finder.h"
#include "geom/execution.h"
#include "geom/id_vector.h"

namespace cocoon {

class KeptMarks {
 public:
  // Whether marks are kept: without conflict, every good vertex visited.
  bool exists() const { return !state_.empty(); }
  void clear() { state_ = {}; }
  // Keeps marks of a surface, unless they are not told at once. Complexity: O(n).
  void keep(const FacetSet& surface, const CellMarks& marks);
  // Goes on from the state() of another one, whose triangulation had the same cells and vertices in
  // the same slots.
  void resume(MarkState state);
  // By slot. Precondition: no change since the marks were kept.
  const MarkState& state() const { return state_; }

  // After a change of the triangulation and of the candidates. Complexity: O(change).
  void update(const DynamicDelaunay& delaunay, const DelaunayChange& change,
              const LiveCandidates& candidates);
  // When gaps are closed. Complexity: O(moves).
  void renumber(const Renumbering& renumbering, const DynamicDelaunay& delaunay);

  // What mark_cells gives, which is then kept. `cell_at`: a cell at each vertex. Complexity: a look
  // at a byte of each cell and at each triangle, and O(change); or as mark_cells.
  CellMarks mark(const Triangulation& triangulation, const IdVector<VertexId, CellId>& cell_at,
                 const LinkedFacets& surface, const VertexSet& boundary,
                 const KnownLabelsSource& known, const GoodVertexOptions& options,
                 const Execution& execution = {});
  // Calls of mark() that went on from what was kept.
  std::size_t local_marks() const { return local_marks_; }

 private:
  struct Input {
    const Triangulation& triangulation;
    const IdVector<VertexId, CellId>& cell_at;
    const LinkedFacets& surface;
    const VertexSet& boundary;
  };
  std::optional<CellMarks> go_on(const Input& input, const GoodVertexOptions& options);
  std::vector<CellId> changed_cells(const FacetSet& surface) const;
  VertexSet changed_vertices(const Triangulation& triangulation,
                             std::span<const CellId> cells) const;
  std::vector<VertexId> find_good(const Input& input, const VertexSet& changed,
                                  const GoodVertexOptions& options, CellMarks& marks);

  std::size_t local_marks_ = 0;
  MarkState state_;  // also whether a cell is new, and whether something changed at a vertex
  FacetCollector collector_;
  StarFinder stars_;
};

}  // namespace cocoon
