// Samples that do nothing for a surface: it would be the same without them, and they are not there
// because a face is evenly sampled, either. As the rim of a hole that the surface has filled.
#pragma once

#include <cstdint>
#include <span>

#include "delaunay/triangulation.h"
#include "geom/id_vector.h"

namespace cocoon {

struct IdleOptions {
  // Facets lie in one plane if their normals differ by at most this: the cosine of 1 degree.
  double flat_cosine = 0.99985;
  // No facet is well shaped if the circles through their corners are this much wider (radius) than
  // the spacing at the sample, the distance to its second nearest neighbor on the surface. Even
  // samples have facets with ratios near 0.6; n samples on a circle, facets with n / (2 pi).
  double ratio = 2;
};

// Is v on the surface between cells with out = 1 and out = 0, all its facets lie in one plane, and
// none of them is well shaped? Curves that are sampled more densely than the faces beside them are
// features: where they bound nothing, the surface has missed something. `star`: the cells at v.
// Complexity: O(star). Deterministic: a function of the points at v and the facets. Source: ours,
// docs/stages/clean_up_cells.md.
bool is_idle(const Triangulation& triangulation, std::span<const CellId> star,
             const IdVector<CellId, std::uint8_t>& out, VertexId v,
             const IdleOptions& options = {});

}  // namespace cocoon
