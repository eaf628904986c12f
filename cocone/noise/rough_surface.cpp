#include "cocone/noise/rough_surface.h"

#include <utility>

#include "cocone/candidate_triangles.h"
#include "cocone/clean_up_cells.h"
#include "cocone/cocones.h"
#include "cocone/extract_manifold.h"
#include "cocone/mark_cells.h"
#include "cocone/peel_cells.h"
#include "cocone/prune_sharp_edges.h"

namespace cocoon {

RoughSurface::RoughSurface(const Triangulation& triangulation, const Dual& dual,
                           const ReconstructOptions& options, const Execution& execution)
    : triangulation_(triangulation), options_(options) {
  PolesAndSides found = poles_and_sides(triangulation, dual, options.cocone.cosine, execution);
  poles_ = std::move(found.poles);
  const Cocones cocones = intersect_cocones(triangulation, std::move(found.sides), execution);
  labels_ = boundary_samples(triangulation, dual, poles_, cocones, options.boundary, execution);
  good_.good = VertexSet(triangulation.num_vertices(), 0);
  if (labels_.interior() == 0) return;
  PrunedCandidates pruned = prune_sharp_edges(
      triangulation, list_candidate_triangles(triangulation, cocones, labels_.boundary, execution),
      options.prune, execution);
  triangles_ =
      extract_manifold(triangulation, std::move(pruned.left), pruned.umbrella, execution).triangles;
  good_ = good_vertices(triangles_, labels_.boundary, options.good_vertices, execution);
}

IdVector<CellId, std::uint8_t> RoughSurface::outside(const Execution& execution) const {
  if (labels_.interior() == 0) return {};
  CellMarks marks = mark_cells(triangulation_, triangles_, good_, {}, execution);
  marks = peel_cells(triangulation_, triangles_.set, std::move(marks), options_.peel, execution);
  clean_up_cells(triangulation_, poles_, marks, options_.clean_up, execution);
  return std::move(marks.reached);
}

}  // namespace cocoon
