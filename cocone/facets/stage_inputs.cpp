#include "cocone/facets/stage_inputs.h"

#include <limits>
#include <string>

#include "geom/errors.h"
#include "geom/require_number.h"
#include "geom/require_size.h"

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
  if (facets.size() != 0) require_facets(stage, triangulation, facets.set);
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

}  // namespace cocoon
