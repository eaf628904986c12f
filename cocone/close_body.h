// From marks to the body: the clean-up, with what is known of inside and outside beforehand.
//
// What is known tells the clean-up where marks leave doubt. What is likely does where the surface
// is no rougher by it. A foreign mesh (KnownLabels::is_foreign) cuts sharp edges
// otherwise than facets do: it yields to good vertices where the surface would touch itself.
#pragma once

#include <cstddef>

#include "cocone/boundary_samples.h"
#include "cocone/cell_marks.h"
#include "cocone/clean_up_cells.h"
#include "cocone/facets/linked_facets.h"
#include "cocone/known_labels.h"
#include "cocone/peel_cells.h"
#include "cocone/poles.h"
#include "cocone/reconstruct.h"
#include "delaunay/triangulation.h"
#include "geom/execution.h"
#include "geom/id_vector.h"

namespace cocoon {

// What has led to the marks.
struct MarkedSurface {
  const Triangulation& triangulation;
  const LinkedFacets& surface;  // its links are needed only if needs_links()
  const VertexSet& boundary;
  const Poles& poles;
  const IdVector<VertexId, CellId>* cell_at = nullptr;  // a cell at each vertex; none: found anew
};

struct ClosedBody {
  CellMarks marks;  // `reached`: what is not of the body
  CleanUpCounters clean_up;
  CavityCounters cavities;
  std::size_t yielded_cells = 0;  // as in ReconstructCounters, like these:
  std::size_t likely_cells = 0;
  std::size_t contradicted_likely = 0;
  std::size_t heeded_likely = 0;
};

// Whether something is left to be decided by the clean-up. Complexity: O(1).
inline bool is_in_doubt(const CellMarks& marks) {
  return marks.poor_cells != 0 || marks.conflicts != 0;
}

// Whether the marking may have to be done again. Complexity: O(1).
inline bool needs_links(const KnownLabels& told) {
  return !told.likely.empty() || told.is_foreign();
}

// `peeled`: of peel_cells. `told`: of none unless marks are in doubt, or have not reached all good
// vertices. In paper mode nothing is cleaned up.
// Complexity: O(cells) and that of clean_up_cells; if something likely is contradicted up to three
// times, with markings and peels of its own, and where a foreign mesh tells, in up to
// ReconstructOptions::yield_rounds + 1 rounds each, of two markings if the first has asked it.
// Deterministic. Errors: InputError for labels of another triangulation, by their number, and for
// options out of range; Cancelled. Source: ours, docs/stages/known_labels.md.
ClosedBody close_body(const MarkedSurface& marked, CellMarks peeled, const KnownLabels& told,
                      const ReconstructOptions& options, const Execution& execution = {});

}  // namespace cocoon
