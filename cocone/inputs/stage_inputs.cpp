#include "cocone/inputs/stage_inputs.h"

#include <limits>
#include <string>

#include "cocone/boundary_loops.h"
#include "cocone/clean_up_cells.h"
#include "cocone/noise_filter.h"
#include "geom/errors.h"
#include "geom/messages/require_number.h"
#include "geom/messages/require_size.h"

namespace cocoon {

namespace {
constexpr double infinity = std::numeric_limits<double>::infinity();
}  // namespace

void require_dual(const char* stage, const Triangulation& triangulation, const Dual& dual) {
  const std::size_t cells = triangulation.num_cells();
  const std::size_t infinite = cells - triangulation.num_finite_cells();
  if (dual.is_lean()) {
    require_size(stage, "rays of the dual", dual.rays.size(), infinite);
  } else {
    require_size(stage, "centers of the dual", dual.centers.size(), cells);
  }
}

void require_poles(const char* stage, const Triangulation& triangulation, const Poles& poles) {
  const std::size_t vertices = triangulation.num_vertices();
  require_size(stage, "normals of the poles", poles.normals.size(), vertices);
  require_size(stage, "heights of the poles", poles.heights.size(), vertices);
  require_size(stage, "flags of degenerate poles", poles.degenerate.size(), vertices);
}

void require_sides(const char* stage, const Triangulation& triangulation, const ConeSides& sides) {
  require_options(stage, CoconeOptions{sides.cosine});
  require_size(stage, "sides of cells to the cones", sides.of_cells.size(),
               triangulation.num_cells());
}

void require_cocones(const char* stage, const Triangulation& triangulation,
                     const Cocones& cocones) {
  const std::size_t facets = cocones.facets.size();
  require_size(stage, "rows of the cocones", cocones.rows.size(), facets);
  require_size(stage, "corners of the cocones", cocones.corners.size(), facets);
  require_size(stage, "mirrors of the cocones", cocones.mirrors.size(), facets);
  if (facets == 0) return;
  // The last one is the largest, and hardly the same triangle in another triangulation.
  const FacetId last = cocones.facets.back();
  if (cell_of(last).index() < triangulation.num_finite_cells() &&
      triangulation.facet_vertices(last) == cocones.corners.back()) {
    return;
  }
  throw InputError(std::string(stage) +
                   ": the cocones are those of another triangulation; intersect those of this one");
}

void require_vertex_flags(const char* stage, const Triangulation& triangulation,
                          const VertexSet& flags) {
  require_size(stage, "flags of vertices", flags.size(), triangulation.num_vertices());
}

void require_facets(const char* stage, const Triangulation& triangulation, const FacetSet& facets) {
  require_size(stage, "cells of a set of facets", facets.num_cells(), triangulation.num_cells());
}

void require_facets(const char* stage, const Triangulation& triangulation,
                    const LinkedFacets& facets) {
  require_facets(stage, triangulation, facets.set);
}

void require_marked(const char* stage, const Triangulation& triangulation, const CellMarks& marks) {
  const std::size_t vertices = triangulation.num_vertices();
  require_size(stage, "labels of cells", marks.labels.size(), triangulation.num_cells());
  require_size(stage, "flags of good vertices", marks.good.size(), vertices);
  require_size(stage, "flags of visited vertices", marks.visited.size(), vertices);
}

void require_peeled(const char* stage, const Triangulation& triangulation, const CellMarks& marks) {
  const std::size_t cells = triangulation.num_cells();
  require_size(stage, "labels of cells", marks.labels.size(), cells);
  require_size(stage, "flags of reached cells", marks.reached.size(), cells);
  if (!marks.known.empty()) require_size(stage, "known labels of cells", marks.known.size(), cells);
  require_vertex_flags(stage, triangulation, marks.good);
  if (marks.conflicts != 0) require_vertex_flags(stage, triangulation, marks.contradicted);
}

void require_clean_up(const char* stage, const Triangulation& triangulation, const Poles& poles,
                      const CellMarks& marks, const CleanUpOptions& options,
                      const IdVector<VertexId, CellId>* cell_at) {
  require_options(stage, options);
  require_peeled(stage, triangulation, marks);
  const std::size_t vertices = triangulation.num_vertices();
  require_size(stage, "normals of the poles", poles.normals.size(), vertices);
  if (cell_at != nullptr) require_size(stage, "cells at vertices", cell_at->size(), vertices);
}

void require_options(const char* stage, const CoconeOptions& options) {
  require_number(stage, "cocone.cosine", options.cosine, 0, 1);
}

void require_options(const char* stage, const BoundaryOptions& options) {
  require_number(stage, "boundary.rho", options.rho, 0, infinity);
  require_number(stage, "boundary.alpha_cosine", options.alpha_cosine, -1, 1);
}

void require_options(const char* stage, const PruneOptions& options) {
  require_number(stage, "prune.sharp_cosine", options.sharp_cosine, -infinity, infinity);
  require_number(stage, "prune.keep_cosine", options.keep_cosine, -infinity, infinity);
}

void require_options(const char* stage, const GoodVertexOptions& options) {
  require_number(stage, "good_vertices.fold_cosine", options.fold_cosine, -infinity, infinity);
  require_number(stage, "good_vertices.crease_cosine", options.crease_cosine, -infinity, infinity);
}

void require_options(const char* stage, const CleanUpOptions& options) {
  const CleanUpOptions& o = options;
  require_amounts(stage, {{"clean_up.stretch_cost", o.stretch_cost},
                          {"clean_up.stretch_ratio", o.stretch_ratio},
                          {"clean_up.evidence_weight", o.evidence_weight},
                          {"clean_up.full_pole_ratio", o.full_pole_ratio},
                          {"clean_up.mark_weight", o.mark_weight},
                          {"clean_up.flat_ratio", o.flat_ratio},
                          {"clean_up.defect_cost", o.defect_cost},
                          {"clean_up.unused_cost", o.unused_cost},
                          {"clean_up.near_surface", o.near_surface},
                          {"clean_up.outlier_ratio", o.outlier_ratio},
                          {"clean_up.handle_cost", o.handle_cost},
                          {"clean_up.idle_cost", o.idle_cost},
                          {"clean_up.idle.ratio", o.idle.ratio},
                          {"clean_up.max_rise", o.max_rise},
                          {"clean_up.max_closing_rise", o.max_closing_rise},
                          {"clean_up.component_cost", o.component_cost},
                          // Of more than all: no clump is too large.
                          {"clean_up.most_clump_share", o.most_clump_share}});
  require_number(stage, "clean_up.near_pole_ratio (up to full_pole_ratio)", o.near_pole_ratio, 0,
                 o.full_pole_ratio);
  require_shares(stage, {{"clean_up.pole_good_share", o.pole_good_share},
                         {"clean_up.mark_credit", o.mark_credit}});
  require_cosines(stage, {{"clean_up.idle.flat_cosine", o.idle.flat_cosine},
                          {"clean_up.deep_cosine", o.deep_cosine},
                          {"clean_up.deeper_cosine", o.deeper_cosine}});
  require_number(stage, "clean_up.thin_support", o.thin_support, 0, 4);
}

void require_options(const char* stage, const NoiseOptions& options) {
  require_neighbors(stage, options.neighbors);
  require_amounts(stage, {{"noise.outlier_ratio", options.outlier_ratio},
                          {"noise.clump_link_ratio", options.clump_link_ratio},
                          {"noise.large_ratio", options.large_ratio}});
  require_shares(
      stage, {{"noise.clump_share", options.clump_share}, {"noise.max_leak", options.max_leak}});
  require_cosines(stage, {{"noise.deep_cosine", options.deep_cosine}});
}

void require_options(const char* stage, const BoundaryLoopOptions& options) {
  require_shares(stage, {{"loops.min_component_share", options.min_component_share}});
  require_amounts(stage, {{"loops.min_perimeter_in_edges", options.min_perimeter_in_edges}});
}

void require_neighbors(const char* stage, std::size_t neighbors) {
  require_number(stage, "neighbors", static_cast<double>(neighbors), 1, infinity);
}

}  // namespace cocoon
